// Buildings made again by brute force.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

#include <glm/geometric.hpp>

#include "ingest/footprints.h"
#include "ingest/view_frame.h"
#include "render/objects/level_plane.h"
#include "tests/render/objects/prism_oracle.h"

namespace terrview {

// A building built again from its feature, without the renderer's code: walls, and a level roof.
struct House {
  PrismOracle oracle;
  glm::dvec3 middle_m;
  double radius_m = 0;

  [[nodiscard]] std::optional<double> first_m(const Ray& ray) const {
    const glm::dvec3 way = glm::normalize(ray.direction);
    const glm::dvec3 to = middle_m - ray.origin_m;
    if (glm::length(to - glm::dot(to, way) * way) > radius_m) return std::nullopt;
    return oracle.first_m({ray.origin_m - middle_m, way});
  }
};

inline House house_of(const Footprint& footprint, const ViewFrame& frame, double base_m,
                      double below_m = 300) {
  House house;
  std::vector<Polygon::Ring> rings = footprint.polygons.at(0);
  glm::dvec2 middle(0);
  for (Polygon::Ring& ring : rings)
    for (glm::dvec2& corner : ring) {
      corner = frame.to_ground({corner.y, corner.x});
      middle = corner;
    }
  const VerticalFrame& vertical = frame.terrain()->frame();
  house.middle_m = {middle, vertical.at(middle).z_m(base_m)};
  for (Polygon::Ring& ring : rings)
    for (glm::dvec2& corner : ring) {
      corner -= middle;
      house.radius_m = std::max(house.radius_m, glm::length(corner));
    }
  const double roof_m = *footprint.height_m;
  house.radius_m += roof_m + below_m;
  house.oracle = {.rings = rings,
                  .slope = level_plane(vertical, middle, base_m).slope,
                  .base_m = -below_m,
                  .roof_m = [=](glm::dvec2) { return roof_m; },
                  .lowest_roof_m = roof_m,
                  .highest_roof_m = roof_m,
                  .steps = 1};
  return house;
}

// The lowest ground at a footprint's corners and all over it.
inline double lowest_ground_m(const Footprint& footprint, const ViewFrame& frame) {
  double lowest_m = std::numeric_limits<double>::infinity();
  for (const glm::dvec2& corner : footprint.polygons.at(0).at(0))
    lowest_m =
        std::min(lowest_m,
                 frame.terrain()->ground_at(frame.to_ground({corner.y, corner.x}))->scene_height_m);
  return lowest_m;
}

}  // namespace terrview

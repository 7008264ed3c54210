// What a prism is, point by point, and by that where a ray first meets it: no code of the renderer.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/objects/polygon.h"
#include "terrain/ray.h"

namespace terrview {

// A solid over a footprint, its heights those above a plane through the origin.
struct PrismOracle {
  std::vector<Polygon::Ring> rings;
  glm::dvec2 slope{0, 0};
  double base_m = 0;
  std::function<double(glm::dvec2)> roof_m;
  double lowest_roof_m = 0;
  double highest_roof_m = 0;
  int steps = 4000;  // through the heights of the roof

  [[nodiscard]] bool over_footprint(glm::dvec2 p) const {
    bool inside = false;
    for (const Polygon::Ring& ring : rings) {
      for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
        if ((ring[i].y > p.y) != (ring[j].y > p.y) &&
            p.x < (ring[j].x - ring[i].x) * (p.y - ring[i].y) / (ring[j].y - ring[i].y) + ring[i].x)
          inside = !inside;
      }
    }
    return inside;
  }

  [[nodiscard]] double height_m(const glm::dvec3& p) const {
    return p.z - slope.x * p.x - slope.y * p.y;
  }

  [[nodiscard]] bool contains(const glm::dvec3& p) const {
    const glm::dvec2 ground(p);
    const double height = height_m(p);
    return height > base_m && over_footprint(ground) && height < roof_m(ground);
  }

  // The distances at which the ray crosses the planes of walls and base, and many where it may
  // cross the roof.
  [[nodiscard]] std::vector<double> candidates_m(const Ray& ray) const {
    const glm::dvec3 d = glm::normalize(ray.direction);
    std::vector<double> all{0};
    for (const Polygon::Ring& ring : rings) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const glm::dvec2 edge = ring[(i + 1) % ring.size()] - ring[i];
        const double towards = edge.x * d.y - edge.y * d.x;
        const glm::dvec2 to = ring[i] - glm::dvec2(ray.origin_m);
        if (towards != 0) all.push_back((edge.x * to.y - edge.y * to.x) / towards);
      }
    }
    const double rise = d.z - slope.x * d.x - slope.y * d.y;
    const double height = height_m(ray.origin_m);
    all.push_back((base_m - height) / rise);
    const double low = std::min((lowest_roof_m - height) / rise, (highest_roof_m - height) / rise);
    const double high = std::max((lowest_roof_m - height) / rise, (highest_roof_m - height) / rise);
    for (int i = 0; i <= steps; ++i)
      all.push_back(low - 1e-6 + (high - low + 2e-6) * i / static_cast<double>(steps));
    std::erase_if(all, [](double t) { return !(t >= 0); });
    std::sort(all.begin(), all.end());
    return all;
  }

  // The first distance at which the ray passes from outside to inside or back.
  [[nodiscard]] std::optional<double> first_m(const Ray& ray) const {
    const glm::dvec3 d = glm::normalize(ray.direction);
    const auto inside = [&](double t) { return contains(ray.origin_m + t * d); };
    const std::vector<double> at = candidates_m(ray);
    double before = 0;
    for (std::size_t i = 0; i + 1 < at.size(); ++i) {
      double after = (at[i] + at[i + 1]) / 2;
      if (inside(after) == inside(before)) {
        before = after;
        continue;
      }
      for (int halving = 0; halving < 100; ++halving) {
        const double middle = (before + after) / 2;
        (inside(middle) == inside(before) ? before : after) = middle;
      }
      return after;
    }
    return std::nullopt;
  }
};

}  // namespace terrview

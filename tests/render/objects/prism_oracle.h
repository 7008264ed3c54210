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
  static constexpr double kBeside = 1e-10;

  std::vector<Polygon::Ring> rings;
  glm::dvec2 slope{0, 0};
  double base_m = 0;
  std::function<double(glm::dvec2)> roof_m;
  double lowest_roof_m = 0;
  double highest_roof_m = 0;
  int steps = 400;  // through the heights of the roof

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

  // Below the roof, which goes on beside the footprint.
  [[nodiscard]] double depth_m(const glm::dvec3& p) const {
    return roof_m(glm::dvec2(p)) - height_m(p);
  }

  // Between two distances, that at which the ray is deepest below the roof, or highest above it.
  [[nodiscard]] double turn_m(const Ray& ray, double low, double high, bool deepest) const {
    const glm::dvec3 d = glm::normalize(ray.direction);
    for (int third = 0; third < 100; ++third) {
      const double left = low + (high - low) / 3;
      const double right = high - (high - low) / 3;
      const bool rises = depth_m(ray.origin_m + left * d) < depth_m(ray.origin_m + right * d);
      (rises == deepest ? low : high) = rises == deepest ? left : right;
    }
    return (low + high) / 2;
  }

  // The first distance at which the ray passes from outside to inside or back: between two
  // candidates, beside one of them (where it cuts the edge of a wall and the roof), or where it
  // grazes the roof between them.
  [[nodiscard]] std::optional<double> first_m(const Ray& ray) const {
    const glm::dvec3 d = glm::normalize(ray.direction);
    const std::vector<double> at = candidates_m(ray);
    std::vector<double> all{0};
    for (std::size_t i = 0; i + 1 < at.size(); ++i)
      all.insert(all.end(), {at[i] + kBeside, (at[i] + at[i + 1]) / 2, at[i + 1] - kBeside});
    std::sort(all.begin(), all.end());
    std::vector<double> depths_m;
    for (const double t : all) depths_m.push_back(depth_m(ray.origin_m + t * d));

    const bool begins_inside = contains(ray.origin_m);
    const auto is_past = [&](double t) { return contains(ray.origin_m + t * d) != begins_inside; };
    for (std::size_t i = 1; i < all.size(); ++i) {
      double after = all[i];
      const bool turns =
          i + 1 < all.size() && (depths_m[i] > depths_m[i - 1]) != (depths_m[i + 1] > depths_m[i]);
      if (!is_past(after) && turns) after = turn_m(ray, all[i - 1], all[i + 1], !begins_inside);
      if (!is_past(after)) continue;
      double before = all[i - 1];
      for (int halving = 0; halving < 100; ++halving) {
        const double middle = (before + after) / 2;
        (is_past(middle) ? after : before) = middle;
      }
      return after;
    }
    return std::nullopt;
  }
};

}  // namespace terrview

// The ground that a grid takes up: all of it lies in the disc, or all of it that can matter.
#pragma once

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace terrview {

struct GroundDisc {
  glm::dvec2 centre_m{0, 0};
  double radius_m = 1;

  // The point itself where it lies in the disc, else the one of the circle below it.
  [[nodiscard]] glm::dvec2 nearest(glm::dvec2 ground_m) const {
    const glm::dvec2 from_centre = ground_m - centre_m;
    const double away2 = glm::dot(from_centre, from_centre);
    if (away2 <= radius_m * radius_m) return ground_m;
    return centre_m + from_centre / (std::sqrt(away2) / radius_m);
  }
};

}  // namespace terrview

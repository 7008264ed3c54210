// Where a line of sight meets the clouds: a plane above the eye, or a shell that follows the Earth.
//
// In the view frame (docs/frames.md) the shell has z = height - s^2 / (2 R) at the distance s, with
// 1 / R the Earth's curvature less the light's: the second-order part of the frame's own formula,
// right to 1e-3 of the drop up to 250 km.
#pragma once

#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace terrview {

struct CloudLayer {
  double height_m = 2500;      // above the eye; not above 0: the eye is in or over the clouds
  double curvature_per_m = 0;  // 1 / R; 0 is a plane
  double cell_m = 8000;        // the side of a root cell of the field
  glm::dvec2 origin_m{0, 0};   // the eye's place in the field, metres east and north
  double reach_m = 250000;     // no clouds beyond

  // How far along the direction, in its lengths; nullopt where it meets none within reach.
  [[nodiscard]] std::optional<double> distance(const glm::dvec3& direction) const;
  // Root cells east and north of the field's origin.
  [[nodiscard]] glm::dvec2 field_place(const glm::dvec2& ground_m) const {
    return (ground_m + origin_m) / cell_m;
  }
  // The layer's point above a place of the field.
  [[nodiscard]] glm::dvec3 point_m(const glm::dvec2& place) const {
    const glm::dvec2 ground_m = place * cell_m - origin_m;
    const double drop_m = curvature_per_m / 2 * (ground_m.x * ground_m.x + ground_m.y * ground_m.y);
    return {ground_m.x, ground_m.y, height_m - drop_m};
  }
};

}  // namespace terrview

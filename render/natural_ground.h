// The colour of ground as altitude and steepness make it: grass, scree, rock, snow.
#pragma once

#include <numbers>

#include <glm/vec3.hpp>

namespace terrview {

struct NaturalGround {
  double snow_line_m = 2800;                                // half of level ground is white
  double rock_slope_rad = 35.0 / 180.0 * std::numbers::pi;  // half of such slopes are rock
};

// Linear Rec. 709. Meadows become pastures 2000 to 900 m under the snow line and scree 900 to 100 m
// under it; rock takes over within 8 degrees about its slope; snow comes within 300 m about its
// line, and thins from 3 to 20 degrees beyond the rock's slope. Height and slope are those of the
// DEM, before z_scale. The colour has no steps, nor has its slope.
[[nodiscard]] glm::vec3 natural_color(const NaturalGround& ground, double height_m,
                                      double slope_rad);

// The slope of ground of a normal in the plumb line's frame, before z_scale.
[[nodiscard]] double slope_of(const glm::dvec3& normal, double z_scale);

}  // namespace terrview

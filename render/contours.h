// Contour lines, as pixels see them.
#pragma once

#include <glm/mat2x2.hpp>
#include <glm/vec3.hpp>

#include "render/color_ramp.h"

namespace terrview {

struct Contours {
  double interval_m = 0;  // 0: no lines
  glm::vec3 color = from_srgb8(96, 58, 30);
  float opacity = 0.75F;
};

// The share of a pixel that lines one pixel wide take, where its centre sees the height and the
// height changes by `rise_m` from pixel to pixel. Lines closer than four pixels fade, and are gone
// at two. Level ground has none.
[[nodiscard]] double contour_share(double height_m, double rise_m, double interval_m);

// How much the height of ground of that normal (before z_scale) changes over the longer way across
// a footprint of the sides given, seen from above.
[[nodiscard]] double rise_over(const glm::dmat2& sides_m, const glm::dvec3& normal, double z_scale);

}  // namespace terrview

// Whether neighbours in a picture differ enough to be seen.
#pragma once

#include "render/image.h"
#include "render/sampling.h"

namespace terrview {

// A sample's colour as the eye tells colours apart: in sRGB, 0 to 1.
[[nodiscard]] glm::vec3 seen_color(const glm::vec3& linear);

// The largest difference of a component.
[[nodiscard]] float contrast_between(const glm::vec3& seen_a, const glm::vec3& seen_b);

// Whether two rays meet things at very different distances: a quarter of the nearer, or one of them
// nothing. An outline lies between them, whatever their colours.
[[nodiscard]] bool depth_steps(const Sample& a, const Sample& b);

// seen_color() of every traced sample.
[[nodiscard]] Image seen_colors(const Raster<Sample>& samples, int threads);

}  // namespace terrview

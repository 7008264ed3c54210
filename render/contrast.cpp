#include "render/contrast.h"

#include <algorithm>
#include <cmath>

#include "render/color_ramp.h"
#include "render/parallel.h"

namespace terrview {

glm::vec3 seen_color(const glm::vec3& linear) {
  return {to_srgb(linear.x), to_srgb(linear.y), to_srgb(linear.z)};
}

float contrast_between(const glm::vec3& seen_a, const glm::vec3& seen_b) {
  return std::max({std::abs(seen_a.x - seen_b.x), std::abs(seen_a.y - seen_b.y),
                   std::abs(seen_a.z - seen_b.z)});
}

bool depth_steps(const Sample& a, const Sample& b) {
  if (a.ground() != b.ground()) return true;
  if (!a.ground()) return false;
  constexpr float kStep = 1.25F;
  return a.distance_m > kStep * b.distance_m || b.distance_m > kStep * a.distance_m;
}

Image seen_colors(const Raster<Sample>& samples, int threads) {
  Image seen(samples.width_px(), samples.height_px());
  parallel_for(samples.height_px(), threads, [&](int row) {
    for (int column = 0; column < samples.width_px(); ++column) {
      const Sample& sample = samples.at(column, row);
      if (sample.traced()) seen.at(column, row) = seen_color(sample.color);
    }
  });
  return seen;
}

}  // namespace terrview

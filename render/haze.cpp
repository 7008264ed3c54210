#include "render/haze.h"

#include <algorithm>
#include <cmath>

namespace terrview {
namespace {

constexpr double kLeast_px = 0.2;       // a blur that nobody sees
constexpr double kWidest_px = 8;        // the largest standard deviation
constexpr float kDepthStep = 0.2F;      // relative; beyond it nothing mixes
constexpr double kSparse_px = 1;        // blurred by this much, every other pixel is enough
constexpr float kSparseSpread = 1.15F;  // furthest over nearest

}  // namespace

Haze::Sum Haze::around(glm::ivec2 pixel, float distance_m) const {
  const double sigma_px = std::min(kWidest_px, per_m_ * static_cast<double>(distance_m));
  const int radius = static_cast<int>(std::ceil(2 * sigma_px));
  const auto falloff = static_cast<float>(-1 / (2 * sigma_px * sigma_px));
  Sum sum;
  for (int row = std::max(0, pixel.y - radius);
       row <= std::min(base_.height_px() - 1, pixel.y + radius); ++row) {
    for (int column = std::max(0, pixel.x - radius);
         column <= std::min(base_.width_px() - 1, pixel.x + radius); ++column) {
      const glm::ivec2 step = glm::ivec2(column, row) - pixel;
      const int squared = step.x * step.x + step.y * step.y;
      if (squared == 0 || squared > radius * radius) continue;
      const Sample& other = base_.at(column, row);
      if (!other.ground()) continue;
      const float apart = std::abs(other.distance_m - distance_m) /
                          (kDepthStep * std::min(other.distance_m, distance_m));
      if (apart >= 1) continue;
      const float weight =
          std::exp(falloff * static_cast<float>(squared)) * (1 - apart) * (1 - apart);
      sum.color += weight * other.color;
      sum.weight += weight;
    }
  }
  return sum;
}

glm::vec3 Haze::blurred(glm::ivec2 pixel, const Sample& sample) const {
  if (!sample.ground() || per_m_ * static_cast<double>(sample.distance_m) < kLeast_px)
    return sample.color;
  const Sum sum = around(pixel, sample.distance_m);
  return (sample.color + sum.color) / (1 + sum.weight);
}

glm::vec3 Haze::filled(glm::ivec2 pixel) const {
  const Sum sum = around(pixel, distance_beside(pixel).value());
  return sum.color / sum.weight;
}

bool Haze::fills(glm::ivec2 pixel) const { return distance_beside(pixel).has_value(); }

std::optional<float> Haze::distance_beside(glm::ivec2 pixel) const {
  const glm::ivec2 low(pixel.x & ~1, pixel.y & ~1);
  const glm::ivec2 high((pixel.x + 1) & ~1, (pixel.y + 1) & ~1);
  if (low == high || high.x >= base_.width_px() || high.y >= base_.height_px()) return std::nullopt;
  float nearest_m = std::numeric_limits<float>::infinity();
  float furthest_m = 0;
  float sum_m = 0;
  for (const glm::ivec2& corner : {low, {high.x, low.y}, {low.x, high.y}, high}) {
    const Sample& sample = base_.at(corner.x, corner.y);
    if (!sample.ground()) return std::nullopt;
    nearest_m = std::min(nearest_m, sample.distance_m);
    furthest_m = std::max(furthest_m, sample.distance_m);
    sum_m += sample.distance_m;
  }
  if (per_m_ * static_cast<double>(nearest_m) < kSparse_px ||
      furthest_m > kSparseSpread * nearest_m)
    return std::nullopt;
  return sum_m / 4;
}

}  // namespace terrview

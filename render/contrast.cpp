#include "render/contrast.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/color_ramp.h"

namespace terrview {

namespace {

constexpr float kDepthStep = 1.25F;

}  // namespace

glm::vec3 seen_color(const glm::vec3& linear) {
  return {nearly_srgb(linear.x), nearly_srgb(linear.y), nearly_srgb(linear.z)};
}

float contrast_between(const glm::vec3& seen_a, const glm::vec3& seen_b) {
  return std::max({std::abs(seen_a.x - seen_b.x), std::abs(seen_a.y - seen_b.y),
                   std::abs(seen_a.z - seen_b.z)});
}

bool depth_steps(const Sample& a, const Sample& b) {
  if (a.ground() != b.ground()) return true;
  if (!a.ground()) return false;
  return a.distance_m > kDepthStep * b.distance_m || b.distance_m > kDepthStep * a.distance_m;
}

SeenRows::SeenRows(const Raster<Sample>& samples, int first, int count)
    : first_(first), stride_(static_cast<std::size_t>(samples.width_px()) + 2) {
  const std::size_t size = stride_ * (static_cast<std::size_t>(count) + 2);
  distances_m_.resize(size, Sample{}.distance_m);
  for (std::vector<float>* values : {&reds_, &greens_, &blues_}) values->resize(size);
  const int end = std::min(first + count + 1, samples.height_px());
  for (int row = std::max(first - 1, 0); row < end; ++row) {
    std::size_t i = static_cast<std::size_t>(row - first + 1) * stride_ + 1;
    for (int column = 0; column < samples.width_px(); ++column, ++i) {
      const Sample& sample = samples.at(column, row);
      const glm::vec3 seen = seen_color(sample.color);
      distances_m_[i] = sample.distance_m;
      reds_[i] = seen.r;
      greens_[i] = seen.g;
      blues_[i] = seen.b;
    }
  }
}

SeenRows::Row SeenRows::row_at(int row, int right) const {
  const std::size_t from = static_cast<std::size_t>(row - first_ + 1) * stride_ + 1;
  const std::size_t i = right < 0 ? from - 1 : from + static_cast<std::size_t>(right);
  return {&distances_m_[i], &reds_[i], &greens_[i], &blues_[i]};
}

void SeenRows::compare(int row, std::span<float> contrasts, std::span<std::int32_t> steps) const {
  std::ranges::fill(contrasts, 0.0F);
  std::ranges::fill(steps, 0);
  for (const int down : {-1, 0, 1}) {
    for (const int right : {-1, 0, 1}) {
      if (down != 0 || right != 0)
        compare(row_at(row, 0), row_at(row + down, right), contrasts, steps);
    }
  }
}

void SeenRows::compare(const Row& a, const Row& b, std::span<float> contrasts,
                       std::span<std::int32_t> steps) {
  constexpr float kSky_m = std::numeric_limits<float>::infinity();
  // Branches, and no aliases known, would keep compilers from using vectors.
  float* __restrict const contrast = contrasts.data();
  std::int32_t* __restrict const step = steps.data();
  for (std::size_t i = 0; i < contrasts.size(); ++i) {
    const float a_m = a.distance_m[i];
    const float b_m = b.distance_m[i];
    step[i] |= int{a_m > kDepthStep * b_m} | int{b_m > kDepthStep * a_m};
    const float most = std::max({std::abs(a.red[i] - b.red[i]), std::abs(a.green[i] - b.green[i]),
                                 std::abs(a.blue[i] - b.blue[i])});
    const int counts = int{b_m == b_m} & (int{a_m < kSky_m} | int{b_m < kSky_m});
    const float counted = counts != 0 ? most : 0.0F;
    contrast[i] = counted > contrast[i] ? counted : contrast[i];
  }
}

}  // namespace terrview

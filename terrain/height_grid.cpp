#include "terrain/height_grid.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace terrview {

namespace {

// The extremes of several sequences of posts, side by side, so that they are found in vectors.
class Extremes {
 public:
  static constexpr std::size_t kCount = 16;

  Extremes() {
    lowest_m_.fill(std::numeric_limits<float>::infinity());
    highest_m_.fill(-std::numeric_limits<float>::infinity());
  }

  void add(const float* heights_m) {
    for (std::size_t i = 0; i < kCount; ++i) add(i, heights_m[i]);
  }

  void add(std::size_t i, float height_m) {
    // Comparisons with NaN are false, so posts without data never count.
    lowest_m_[i] = height_m < lowest_m_[i] ? height_m : lowest_m_[i];
    highest_m_[i] = height_m > highest_m_[i] ? height_m : highest_m_[i];
    holes_[i] |= height_m != height_m ? 1 : 0;
  }

  [[nodiscard]] HeightRange range() const {
    return {*std::ranges::min_element(lowest_m_), *std::ranges::max_element(highest_m_),
            *std::ranges::max_element(holes_) != 0};
  }

 private:
  std::array<float, kCount> lowest_m_{};
  std::array<float, kCount> highest_m_{};
  std::array<int, kCount> holes_{};
};

}  // namespace

HeightRange height_range(const HeightGrid& grid) {
  Extremes extremes;
  const std::size_t count = grid.heights_m.size();
  const std::size_t whole = count - count % Extremes::kCount;
  for (std::size_t i = 0; i < whole; i += Extremes::kCount) extremes.add(&grid.heights_m[i]);
  for (std::size_t i = whole; i < count; ++i) extremes.add(i - whole, grid.heights_m[i]);
  const HeightRange range = extremes.range();
  if (range.lowest_m > range.highest_m) {
    constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
    return {kNone, kNone, range.has_holes};
  }
  return range;
}

}  // namespace terrview

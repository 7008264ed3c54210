// Colours for tests, the same for the same seed.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "quantize/color_counts.h"

namespace terrview {

[[nodiscard]] inline std::vector<Rgb8> random_colors(std::size_t count, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<Rgb8> colors;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint_fast32_t bits = random();
    colors.emplace_back(bits & 255U, (bits >> 8) & 255U, (bits >> 16) & 255U);
  }
  return colors;
}

// A sky that pales downwards above slopes of two hues, with a little noise: most pixels in few
// cubes of colours.
[[nodiscard]] inline std::vector<Rgb8> landscape_colors(int width_px, int height_px,
                                                        std::uint32_t seed = 1) {
  std::mt19937 random(seed);
  std::vector<Rgb8> colors;
  for (int row = 0; row < height_px; ++row) {
    for (int column = 0; column < width_px; ++column) {
      const int down = 255 * row / height_px;
      const int noise = static_cast<int>(random() % 5);
      if (row < height_px / 2)
        colors.emplace_back(120 + down / 2 + noise, 150 + down / 3, 210 + down / 8);
      else
        colors.emplace_back(60 + 90 * column / width_px + noise, 80 + down / 4 + noise, 40 + noise);
    }
  }
  return colors;
}

[[nodiscard]] inline ColorCounts counts_of(const std::vector<Rgb8>& colors) {
  ColorCounts counts;
  counts.add(colors);
  return counts;
}

}  // namespace terrview

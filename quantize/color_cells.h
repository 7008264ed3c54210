// The colours of a picture in cells fine enough to choose a palette from, and few enough to sort.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "quantize/color_counts.h"

namespace terrview {

// What pixels sum up to. Sums of up to 2^40 pixels are exact.
struct ColorSum {
  std::uint64_t count = 0;
  std::uint64_t r = 0;
  std::uint64_t g = 0;
  std::uint64_t b = 0;
  std::uint64_t squares = 0;  // of all components

  void add(Rgb8 color, std::uint64_t times);
  void add(const ColorSum& other);

  // The mean, rounded; of at least one pixel.
  [[nodiscard]] Rgb8 mean() const;

  // The sum of the squared distances of the pixels from their mean.
  [[nodiscard]] double error() const;
};

struct ColorCell {
  std::uint32_t prefix;  // the first triplets of its colours, as many as ColorCells::level
  ColorSum sum;
};

struct ColorCells {
  int level = kColorBits;
  std::vector<ColorCell> cells = {};  // in the order of prefixes
};

// 48 bytes each.
inline constexpr std::size_t kMaxColorCells = std::size_t{1} << 18;

// One cell for each colour, or for each cube of colours of the finest level that has no more than
// `max_cells`.
[[nodiscard]] ColorCells gather_cells(const ColorCounts& counts,
                                      std::size_t max_cells = kMaxColorCells);

}  // namespace terrview

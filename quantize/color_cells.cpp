#include "quantize/color_cells.h"

#include <algorithm>
#include <array>
#include <bit>

namespace terrview {
namespace {

// How many cubes of each level hold colours of the picture.
std::array<std::size_t, kColorBits + 1> cubes_by_level(const ColorCounts& counts) {
  std::array<std::size_t, kColorBits + 1> cubes{};
  std::uint32_t before = 0;
  bool first = true;
  counts.for_each([&](std::uint32_t triplets, std::uint32_t) {
    // The first triplet that differs opens a new cube at its level and at all below.
    const int equal = first ? 0 : (std::countl_zero(triplets ^ before) - 8) / 3 + 1;
    for (auto level = static_cast<std::size_t>(equal); level < cubes.size(); ++level)
      ++cubes[level];
    before = triplets;
    first = false;
  });
  return cubes;
}

std::uint8_t rounded_share(std::uint64_t sum, std::uint64_t count) {
  return static_cast<std::uint8_t>((2 * sum + count) / (2 * count));
}

}  // namespace

void ColorSum::add(Rgb8 color, std::uint64_t times) {
  const std::uint64_t red = color.r;
  const std::uint64_t green = color.g;
  const std::uint64_t blue = color.b;
  count += times;
  r += times * red;
  g += times * green;
  b += times * blue;
  squares += times * (red * red + green * green + blue * blue);
}

void ColorSum::add(const ColorSum& other) {
  count += other.count;
  r += other.r;
  g += other.g;
  b += other.b;
  squares += other.squares;
}

Rgb8 ColorSum::mean() const {
  return {rounded_share(r, count), rounded_share(g, count), rounded_share(b, count)};
}

double ColorSum::error() const {
  const auto red = static_cast<double>(r);
  const auto green = static_cast<double>(g);
  const auto blue = static_cast<double>(b);
  const double of_mean = (red * red + green * green + blue * blue) / static_cast<double>(count);
  return std::max(0.0, static_cast<double>(squares) - of_mean);
}

ColorCells gather_cells(const ColorCounts& counts, std::size_t max_cells) {
  const auto cubes = cubes_by_level(counts);
  ColorCells gathered;
  while (gathered.level > 0 && cubes[static_cast<std::size_t>(gathered.level)] > max_cells)
    --gathered.level;
  const int dropped_bits = 3 * (kColorBits - gathered.level);
  std::vector<ColorCell>& cells = gathered.cells;
  cells.reserve(cubes[static_cast<std::size_t>(gathered.level)]);
  counts.for_each([&](std::uint32_t triplets, std::uint32_t count) {
    const std::uint32_t prefix = triplets >> dropped_bits;
    if (cells.empty() || cells.back().prefix != prefix) cells.push_back({prefix, {}});
    cells.back().sum.add(color_of_triplets(triplets), count);
  });
  return gathered;
}

}  // namespace terrview

#include "quantize/simple_palettes.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <tuple>

namespace terrview {
namespace {

constexpr std::size_t kFiveBitCubes = 32768;

std::uint8_t spread_evenly(int step, int steps) {
  if (steps == 1) return 128;
  return static_cast<std::uint8_t>((2 * 255 * step + steps - 1) / (2 * (steps - 1)));
}

}  // namespace

Palette fixed_palette(int colors) {
  assert(colors >= 1 && colors <= kMaxPaletteColors);
  const int bits = static_cast<int>(std::bit_width(static_cast<unsigned>(colors))) - 1;
  const int green = 1 << ((bits + 2) / 3);
  const int red = 1 << ((bits + 1) / 3);
  const int blue = 1 << (bits / 3);
  Palette palette;
  for (int r = 0; r < red; ++r)
    for (int g = 0; g < green; ++g)
      for (int b = 0; b < blue; ++b)
        palette.emplace_back(spread_evenly(r, red), spread_evenly(g, green),
                             spread_evenly(b, blue));
  return palette;
}

Palette popular_colors(const ColorCounts& counts, int colors) {
  const auto wanted = static_cast<std::size_t>(colors);
  std::vector<ColorCell> cells = gather_cells(counts, std::max(kFiveBitCubes, 8 * wanted)).cells;
  const auto more_popular = [](const ColorCell& a, const ColorCell& b) {
    return std::tuple(b.sum.count, a.prefix) < std::tuple(a.sum.count, b.prefix);
  };
  const std::size_t kept = std::min(cells.size(), wanted);
  std::partial_sort(cells.begin(), cells.begin() + static_cast<std::ptrdiff_t>(kept), cells.end(),
                    more_popular);
  Palette palette;
  for (std::size_t i = 0; i < kept; ++i) palette.push_back(cells[i].sum.mean());
  return palette;
}

}  // namespace terrview

#include <algorithm>
#include <cmath>
#include <limits>

#include "bench/bench_dem.h"

namespace terrview {
namespace {

// The means of what heights 2 x 2 posts have.
HeightGrid halved(const HeightGrid& fine) {
  HeightGrid coarse{(fine.columns + 1) / 2, (fine.rows + 1) / 2, {}};
  for (int row = 0; row < coarse.rows; ++row)
    for (int column = 0; column < coarse.columns; ++column) {
      float sum = 0;
      int count = 0;
      for (int y = 2 * row; y < std::min(2 * row + 2, fine.rows); ++y)
        for (int x = 2 * column; x < std::min(2 * column + 2, fine.columns); ++x) {
          if (std::isnan(fine.at(x, y))) continue;
          sum += fine.at(x, y);
          ++count;
        }
      coarse.heights_m.push_back(count > 0 ? sum / static_cast<float>(count)
                                           : std::numeric_limits<float>::quiet_NaN());
    }
  return coarse;
}

// The bilinear interpolant of `coarse` at a post of the grid that was halved.
float interpolate(const HeightGrid& coarse, int column, int row) {
  const float u = std::clamp(static_cast<float>(column) / 2 - 0.25F, 0.0F,
                             static_cast<float>(coarse.columns - 1));
  const float v =
      std::clamp(static_cast<float>(row) / 2 - 0.25F, 0.0F, static_cast<float>(coarse.rows - 1));
  const int west = static_cast<int>(u);
  const int north = static_cast<int>(v);
  const int east = std::min(west + 1, coarse.columns - 1);
  const int south = std::min(north + 1, coarse.rows - 1);
  return std::lerp(
      std::lerp(coarse.at(west, north), coarse.at(east, north), u - static_cast<float>(west)),
      std::lerp(coarse.at(west, south), coarse.at(east, south), u - static_cast<float>(west)),
      v - static_cast<float>(north));
}

}  // namespace

// Pull and push (Gortler, Grzeszczuk, Szeliski & Cohen, The Lumigraph, SIGGRAPH 1996).
void cover_voids(HeightGrid& grid) {
  const auto is_void = [](float height_m) { return std::isnan(height_m); };
  if (std::none_of(grid.heights_m.begin(), grid.heights_m.end(), is_void)) return;
  if (grid.columns == 1 && grid.rows == 1) return;
  HeightGrid coarse = halved(grid);
  cover_voids(coarse);
  auto height_m = grid.heights_m.begin();
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column, ++height_m)
      if (is_void(*height_m)) *height_m = interpolate(coarse, column, row);
}

}  // namespace terrview

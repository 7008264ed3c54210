// Points over the cells of a grid, for terrain/sun_shadow.h.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace terrview {

struct alignas(64) GridPoints {
  static constexpr std::size_t kMost = 256;
  using Doubles = std::array<double, kMost>;
  using Ints = std::array<std::int32_t, kMost>;

  // What a map of the sun says of a point; nowhere: in which cell it lies is not sure.
  static constexpr std::int32_t kUnknown = 0, kLit = 1, kShaded = 2, kNowhere = 3;

  std::size_t count = 0;
  alignas(64) Doubles x_m, y_m;  // view frame
  alignas(64) Doubles height;    // in the grid's unit
  alignas(64) Doubles u, v;      // from the cell's first post, in posts
  alignas(64) Ints column, row;  // of the cell
  alignas(64) Ints known;
};

}  // namespace terrview

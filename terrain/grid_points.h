// Points of the ground and their cells, for terrain/sun_shadow.h.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace terrview {

struct alignas(64) GridPoints {
  static constexpr std::size_t kMost = 256;
  using Doubles = std::array<double, kMost>;
  using Ints = std::array<std::int32_t, kMost>;

  std::size_t count = 0;
  alignas(64) Doubles x_m, y_m;  // view frame
  alignas(64) Doubles u, v;      // from the cell's first post, in posts
  alignas(64) Ints column, row;  // of the cell
  alignas(64) Ints light;        // the cell's byte in a SunMap; -1: which cell is not sure
};

}  // namespace terrview

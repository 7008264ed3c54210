// Points over the cells of a grid, for terrain/sun_shadow.h.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace terrview {

struct alignas(64) GridPoints {
  static constexpr std::size_t kMost = 256;
  using Doubles = std::array<double, kMost>;
  using Ints = std::array<std::int32_t, kMost>;

  struct List {
    std::size_t count = 0;
    Ints index;

    void add(std::size_t i) { index[count++] = static_cast<std::int32_t>(i); }
    [[nodiscard]] std::span<const std::int32_t> indices() const { return {index.data(), count}; }
  };

  std::size_t count = 0;
  alignas(64) Doubles x_m, y_m, z_m;  // view frame
  alignas(64) Doubles height;         // in the grid's unit
  alignas(64) Doubles u, v;           // in posts; once looked up, from the cell's first post
  alignas(64) Ints column, row;       // of the cell
  // What a map of the sun says of them: 1 = shaded.
  alignas(64) std::array<std::uint8_t, kMost> shaded;
  List unknown;  // those of which it does not
  List nowhere;  // those in a hole below all ground, or it is not sure in which cell
};

}  // namespace terrview

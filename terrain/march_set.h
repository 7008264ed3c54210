// Rays on their march over a grid: what terrain/march.cpp works on.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace terrview {

// Rays from a point of their lines, packed. Places are counted in posts from the cell (column0,
// row0) in which they begin, distances in metres from where they begin, heights in the grid's unit.
struct alignas(64) MarchSet {
  static constexpr std::size_t kMost = 256;
  using Floats = std::array<float, kMost>;
  using Ints = std::array<std::int32_t, kMost>;

  std::size_t count = 0;
  alignas(64) Ints index;  // of the ray
  alignas(64) Ints column0, row0;
  alignas(64) Floats u, v, rate_u, rate_v, metres_u, metres_v;
  // The ray is at least height + rise * g high (but for slack), and at most bend * g^2 higher.
  alignas(64) Floats height, rise, bend, slack;
  alignas(64) Floats end;  // of the track's piece
  // Where the march stands.
  alignas(64) Ints column, row;
  alignas(64) Floats g;
  // By vector: the lanes that march.
  std::array<std::uint16_t, kMost> marching;

  void move(std::size_t from, std::size_t to) {
    for (Ints* values : {&index, &column0, &row0, &column, &row}) (*values)[to] = (*values)[from];
    for (Floats* values :
         {&u, &v, &rate_u, &rate_v, &metres_u, &metres_v, &height, &rise, &bend, &slack, &end, &g})
      (*values)[to] = (*values)[from];
  }
};

// What became of a ray.
enum class March : std::uint8_t {
  on_its_way,
  free,
  stopped,
  undecided,
  at_knot,  // its track goes on with another piece
};

// Of rays by number.
using Fates = std::array<March, MarchSet::kMost>;

}  // namespace terrview

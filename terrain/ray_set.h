// The rays of a batch while they are traced: what terrain/eye_loop-inl.h works on.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "terrain/eye_tracer.h"

namespace terrview {

// Rays on their way, packed: what a step needs of each.
struct alignas(64) RaySet {
  using Values = EyeRays::Values;

  std::size_t count = 0;
  alignas(64) Values index;  // of the ray in EyeRays
  alignas(64) Values x, y, slope, rate_u, rate_v, metres_u, metres_v;
  // Where tracks bend: the sector of the ray's direction in EyeTracks, and its piece.
  alignas(64) Values sector, begin, end, start_u, start_v;
  alignas(64) Values start;  // its place in EyeFront's starts
  // Where the walk stands.
  alignas(64) Values column, row, g, u, v, z;
  // By vector: the lanes that walk.
  std::array<std::uint8_t, EyeRays::kMost> walking;

  void move(std::size_t from, std::size_t to) {
    for (Values* values : {&index, &x, &y, &slope, &rate_u, &rate_v, &metres_u, &metres_v, &start,
                           &column, &row, &g, &u, &v, &z})
      (*values)[to] = (*values)[from];
  }

  void move_piece(std::size_t from, std::size_t to) {
    for (Values* values : {&sector, &begin, &end, &start_u, &start_v})
      (*values)[to] = (*values)[from];
  }
};

// Rays for the single ray's tracer.
struct RescueList {
  std::array<std::int32_t, EyeRays::kMost> rays;
  std::size_t count = 0;
};

}  // namespace terrview

// The rays of a batch while they are traced: what terrain/eye_loop-inl.h works on.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "terrain/eye_tracer.h"

namespace terrview {

// By byte, the places of its bits, lowest first; hn::Compress of Highway 1.0 looks them up in a
// table that it copies to the stack at every call.
inline constexpr auto kSetBits = [] {
  std::array<std::array<std::uint8_t, 8>, 256> places{};
  for (unsigned byte = 0; byte < 256; ++byte)
    for (std::uint8_t bit = 0, count = 0; bit < 8; ++bit)
      if ((byte >> bit & 1U) != 0) places[byte][count++] = bit;
  return places;
}();

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

  // What there is of each ray; and what more where tracks bend.
  [[nodiscard]] std::array<Values*, 15> walks() {
    return {&index, &x,      &y,   &slope, &rate_u, &rate_v, &metres_u, &metres_v,
            &start, &column, &row, &g,     &u,      &v,      &z};
  }
  [[nodiscard]] std::array<Values*, 5> pieces() {
    return {&sector, &begin, &end, &start_u, &start_v};
  }
};

// Rays for the single ray's tracer.
struct RescueList {
  std::array<std::int32_t, EyeRays::kMost> rays;
  std::size_t count = 0;
};

}  // namespace terrview

// What terrain/eye_scout-inl.h works on, and what it finds.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "terrain/eye_tracer.h"

namespace terrview {

// Rays that go on after their first cells, packed. Places are counted in posts from the eye's cell,
// distances in metres along the ground.
struct alignas(64) ScoutSet {
  static constexpr std::size_t kRoom = EyeRays::kMost + 16;
  using Floats = std::array<float, kRoom>;
  using Ints = std::array<std::int32_t, kRoom>;

  std::size_t count = 0;
  alignas(64) Ints index;  // of the ray
  alignas(64) Ints wedge;  // of the front
  alignas(64) Floats slope, curvature;
  // Where tracks are straight; where they bend, the direction, the first piece of the track and how
  // many further the ray is.
  alignas(64) Floats rate_u, rate_v, metres_u, metres_v;
  alignas(64) Floats x, y;
  alignas(64) Ints first_piece, piece;
  alignas(64) Floats column, row, g;
};

// By ray, the cell in which it meets the ground, unless it proves otherwise in doubles: first post
// of the grid; negative columns: none. And the rays of which floats say nothing.
struct alignas(64) ScoutFinds {
  alignas(64) ScoutSet::Floats column, row;
  alignas(64) ScoutSet::Ints piece;  // of a bent track
  std::array<std::int32_t, EyeRays::kMost> unsure;
  std::array<float, EyeRays::kMost> clear_m;  // of those, up to where they are clear all the same
  std::size_t unsure_count = 0;

  void doubt(std::size_t i, float i_clear_m) {
    unsure[unsure_count] = static_cast<std::int32_t>(i);
    clear_m[unsure_count++] = i_clear_m;
  }
};

}  // namespace terrview

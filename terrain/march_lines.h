// The ground lines of rays that march, in double precision.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "terrain/march_set.h"
#include "terrain/ray.h"

namespace terrview {

struct alignas(64) MarchLines {
  using Doubles = std::array<double, MarchSet::kMost>;

  std::size_t count = 0;
  MarchSet::Ints index;            // of the ray
  alignas(64) Doubles x0, y0, z0;  // where the ray begins
  alignas(64) Doubles x, y, slope;
  alignas(64) Doubles begin, end, start_u, start_v, rate_u, rate_v, metres_u, metres_v;
  alignas(64) Doubles end_u, end_v;
  alignas(64) Doubles to;  // where the line ends

  // A ray whose line is still to be laid: x, y and slope are its direction.
  void aim(std::size_t ray, const Ray& from) {
    const std::size_t i = count++;
    index[i] = static_cast<std::int32_t>(ray);
    x0[i] = from.origin_m.x;
    y0[i] = from.origin_m.y;
    z0[i] = from.origin_m.z;
    x[i] = from.direction.x;
    y[i] = from.direction.y;
    slope[i] = from.direction.z;
    to[i] = from.length_m;
  }

  void move(std::size_t from, std::size_t to_place) {
    if (from == to_place) return;
    index[to_place] = index[from];
    for (Doubles* values : {&x0, &y0, &z0, &x, &y, &slope, &begin, &end, &start_u, &start_v,
                            &rate_u, &rate_v, &metres_u, &metres_v, &end_u, &end_v, &to})
      (*values)[to_place] = (*values)[from];
  }
};

}  // namespace terrview

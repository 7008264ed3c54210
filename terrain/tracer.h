// One ray through the layers of a Terrain: the plain walk, cell by cell, in double precision.
#pragma once

#include <cstdint>

#include "terrain/ray.h"
#include "terrain/terrain.h"

namespace terrview {

enum class Outcome {
  free,   // the ray meets nothing
  hit,    // from above
  below,  // it begins below the ground, or comes below it over an edge of the ground
};

struct Trace {
  Outcome outcome = Outcome::free;
  Hit hit{};  // where outcome is hit
  std::int64_t tests = 0;
};

// `ceiling_m`: no ground lies above this z.
[[nodiscard]] Trace trace(const Terrain& terrain, double ceiling_m, const Ray& ray);

}  // namespace terrview

// One ray through the layers of a Terrain, cell by cell in double precision; where the Terrain has
// pyramids, blocks that lie wholly below the ray are skipped, which changes no result.
#pragma once

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
  TraceCounts counts;
};

// `ceiling_m`: no ground lies above this z.
[[nodiscard]] Trace trace(const Terrain& terrain, double ceiling_m, const Ray& ray);

}  // namespace terrview

// The march of a MarchSet, sixteen rays at a time: see terrain/occlusion.h.
#pragma once

#include "terrain/march_set.h"
#include "terrain/terrain.h"

namespace terrview {

class SunMap;

// Marches the rays of a set until each is decided or cannot be; `fates` are those of its indices.
// With `sun`, the rays all run towards it, and end where they come to a cell over which it knows
// whether they are stopped.
void march(const Terrain& terrain, const SunMap* sun, MarchSet& set, Fates& fates,
           TraceCounts& counts);

}  // namespace terrview

// The ground under a footprint.
#pragma once

#include <optional>

#include "render/objects/polygon.h"
#include "terrain/terrain.h"

namespace terrview {

// Heights of the scene (z_scale included).
struct GroundUnder {
  double lowest_m;
  double mean_m;  // over the area
  double highest_m;
  // No ray sees the ground under or about the footprint lower: the lowest post near.
  double foot_m;
};

// The ground at the corners and, at most half a post apart (of very large footprints, a hundredth
// of their size), along the edges and all over. nullopt where there is none.
[[nodiscard]] std::optional<GroundUnder> ground_under(const Terrain& terrain,
                                                      const Polygon& footprint);

}  // namespace terrview

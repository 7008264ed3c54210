// How steeply the ground of a sector can be seen: the bounds of an EyeFront, made in vectors.
#pragma once

#include <cstddef>
#include <span>

#include "terrain/height_ceilings.h"
#include "terrain/terrain.h"
#include "terrain/wedge_edges.h"

namespace terrview {

// One ring of sectors, and the blocks that cover them.
struct SectorRing {
  double near_m;
  double far_m;
  // The pieces of the tracks that these lie on.
  std::size_t near_piece;
  std::size_t far_piece;
  int level;
  const HeightCeilings::Level* blocks;  // null at level 0: cells are looked up themselves
};

// bounds[kGroup * i + j]: those of ring i and wedge j, of the rings before all wedges have met a
// bound above `highest_slope`. Returns how many rings these are. Sectors reach `margin_cells`
// beyond what their corners say.
[[nodiscard]] std::size_t make_bounds(const Terrain& terrain, const WedgeEdges& edges,
                                      std::span<const SectorRing> rings, double margin_cells,
                                      double highest_slope, float* bounds);

}  // namespace terrview

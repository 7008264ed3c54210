// How steeply the ground of a sector can be seen: the bounds of an EyeFront, made in vectors.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "terrain/eye_front.h"
#include "terrain/ground_map.h"
#include "terrain/height_ceilings.h"
#include "terrain/terrain.h"

namespace terrview {

// The edges of a group of wedges: lines from the eye, two to each.
struct WedgeEdges {
  using Values = std::array<double, EyeFront::kGroup>;
  // One piece of the tracks of the first edges, or of the second.
  struct alignas(64) Piece {
    alignas(64) Values start_u, start_v, rate_u, rate_v;
  };
  // Unit directions, view frame.
  alignas(64) Values x_a, y_a, x_b, y_b;
  // An arc between two edges stays nearer than the line between them so many times as far away.
  double bulge = 1;
  std::vector<double> begins_m;
  std::vector<Piece> pieces_a;
  std::vector<Piece> pieces_b;
};

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

// Those of a group of the wedges that `wedges_a_side` make, widened by more than the rounding with
// which a ray finds its wedge.
[[nodiscard]] WedgeEdges wedge_edges(int group, int wedges_a_side, const GroundMap& map);

// bounds[kGroup * i + j]: those of ring i and wedge j, of the rings before all wedges have met a
// bound above `highest_slope`. Returns how many rings these are. Sectors reach `margin_cells`
// beyond what their corners say.
[[nodiscard]] std::size_t make_bounds(const Terrain& terrain, const WedgeEdges& edges,
                                      std::span<const SectorRing> rings, double margin_cells,
                                      double highest_slope, float* bounds);

}  // namespace terrview

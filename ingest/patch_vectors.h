// A map of patches at many points at once, in vectors.
#pragma once

#include <span>

#include <glm/vec2.hpp>

#include "ingest/ground_disc.h"
#include "ingest/patch_tree.h"
#include "terrain/ground_map.h"

namespace terrview {

// GroundPatch::jacobian() of the leaf under disc.nearest(), point by point, bit for bit.
void patch_jacobians(const PatchTree& patches, const GroundDisc& disc,
                     const GroundMap::GroundPoints& points, const GroundMap::Jacobians& found);

// GroundPatch::at() of the leaf, in the disc; outside of it carried on along the radii, from
// `centre_uv` at the centre: as CurvedGroundMap::to_grid() does, bit for bit.
void patch_places(const PatchTree& patches, const GroundDisc& disc, glm::dvec2 centre_uv,
                  const GroundMap::GroundPoints& points, const GroundMap::Places& found);

// What bounds a piece of a track: see CurvedGroundMap::piece_end_m().
struct PieceRules {
  double error_cells;  // over the grid
  double least_m;
  double at_the_eye_m;  // lines that begin nearer to the eye than this are the eye's
};

// Where pieces end, bit for bit; NaN for lines of the eye or that are outside the disc, and where a
// piece may go on over the next leaf.
void patch_piece_ends(const PatchTree& patches, const GroundDisc& disc, const PieceRules& rules,
                      const GroundMap::GroundLines& lines, const GroundMap::Stretches& stretches,
                      std::span<double> ends_m);

}  // namespace terrview

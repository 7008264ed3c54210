// The jacobians of a map of patches at many points at once, in vectors.
#pragma once

#include "ingest/ground_disc.h"
#include "ingest/patch_tree.h"
#include "terrain/ground_map.h"

namespace terrview {

// GroundPatch::jacobian() of the leaf under disc.nearest(), point by point, bit for bit.
void patch_jacobians(const PatchTree& patches, const GroundDisc& disc,
                     const GroundMap::GroundPoints& points, const GroundMap::Jacobians& found);

}  // namespace terrview

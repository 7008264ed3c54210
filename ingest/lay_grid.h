// Where a DEM lies under the eye: its ground maps.
#pragma once

#include <memory>
#include <vector>

#include <glm/vec2.hpp>

#include "ingest/exact_ground_map.h"
#include "terrain/ground_map.h"

namespace terrview {

// A map and the exact one it stands for.
struct LaidGrid {
  std::shared_ptr<const GroundMap> map;
  ExactGroundMap exact;
};

// The maps of one grid on the curved Earth. An affine one where that is exact enough: it must be
// within GroundMap::kTrackError_cells and kTrackError_rad everywhere on the grid. Ground further
// than `sight_m` from the eye does not matter. A geographic grid that goes around the Earth may lie
// on both sides of the eye, a turn apart: then it has two maps. Throws InputError.
[[nodiscard]] std::vector<LaidGrid> lay_grid(const ExactGroundMap& exact, glm::ivec2 grid_size,
                                             double sight_m);

}  // namespace terrview

// What to read before anything is read: a window of each file, the grids they make, their sizes.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "ingest/dem.h"
#include "ingest/dem_heights.h"
#include "ingest/gdal_scope.h"
#include "ingest/lattice.h"

namespace terrview {

// What to read of one file, and where it lies once rows run south and columns east.
struct DemPart {
  DemHeader header;
  HeightTarget target;
  PostPlacement placement;
  double block_bytes = 0;
};

struct DemPlan {
  std::vector<DemPart> parts;
  std::vector<Mosaic> mosaics;  // whose tiles are the parts
};

// Opens every file, but allocates no heights. Throws InputError, also if the mosaics need more
// memory than the options allow: a header may claim any size.
[[nodiscard]] DemPlan plan_dems(const std::vector<std::string>& paths, const DemOptions& options,
                                GdalScope& scope);

// Posts of the mosaic that belong to a part.
[[nodiscard]] std::size_t covered_posts(const Mosaic& mosaic, const std::vector<DemPart>& parts);

}  // namespace terrview

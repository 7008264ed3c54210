// Where the pixels of a dataset lie.
#pragma once

#include <string>

#include "ingest/dem.h"

class GDALDataset;

namespace terrview {

// `corners` places the pixels' corners: (0, 0) is the upper left one of the first. An empty CRS, or
// one that GDAL does not know, is none.
void set_place(GDALDataset& dataset, const PostPlacement& corners, const std::string& crs_wkt);

}  // namespace terrview

// Zones of visibility to GeoTIFF, through GDAL.
#pragma once

#include <string>

#include "ingest/zone.h"

namespace terrview {

// Two bands of Float32, deflated, on the DEM's posts: "targets seen" and "angle subtended", in
// degrees; both are Zone::kNoData, the file's nodata value, where the DEM has no height.
// `description` becomes the image's. Throws std::runtime_error with the reason, but not the path,
// if writing fails.
void write_zone(const std::string& path, const Zone& zone, const std::string& description = {});

}  // namespace terrview

// Which part of a DEM a view can need, so that the rest is never read.
#pragma once

#include <optional>

#include "ingest/dem.h"
#include "ingest/exact_ground_map.h"

namespace terrview {

// What is known of a view before any height is.
struct ViewSector {
  GeoPoint eye;
  double heading_rad = 0;     // the middle of the view
  double half_width_rad = 0;  // to either side; pi or more = all round
  double reach_m = 0;         // nothing is seen beyond
  // What is seen may be shaded from this azimuth, by ground at this distance or less.
  double sun_azimuth_rad = 0;
  double shadow_m = 0;
};

// The smallest window of the file that holds every post a view can see or be shaded by, with a
// margin for filled voids and normals; the whole file where that can't be told (no CRS, a pole or
// the rim of the projection within reach) or nothing of it is in view. Errs only by too much.
[[nodiscard]] PostWindow visible_window(const DemHeader& header, const ViewSector& sector);

}  // namespace terrview

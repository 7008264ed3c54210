// What the view frame's approximations add to a picture, measured on samples.
#pragma once

#include "ingest/lay_grid.h"
#include "terrain/height_grid.h"
#include "terrain/vertical_frame.h"

namespace terrview {

struct FrameErrors {
  double track_cells = 0;    // of the pieces of tracks, against the exact map
  double direction_rad = 0;  // of posts, with the tracks' part as the eye sees it
};

// Lines in 32 directions from the eye, and 17 x 17 posts against their geocentric directions,
// within `sight_m`. A millisecond or two.
[[nodiscard]] FrameErrors measure_errors(const LaidGrid& laid, const HeightGrid& grid,
                                         const GeoPoint& eye, const VerticalFrame& frame,
                                         double sight_m);

}  // namespace terrview

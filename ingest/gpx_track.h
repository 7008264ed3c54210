// Tracks of GPX files, through GDAL's OGR.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ingest/exact_ground_map.h"

namespace terrview {

struct TrackPoint {
  GeoPoint place;
  std::optional<double> time_s;  // since 1970
};

// The points of all tracks, or else of all routes, in file order. Throws InputError for a file that
// cannot be read, or has fewer than two.
[[nodiscard]] std::vector<TrackPoint> read_gpx_track(const std::string& path);

}  // namespace terrview

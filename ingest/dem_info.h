// What one needs to know of a DEM before choosing an eye.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "ingest/crs_transform.h"
#include "ingest/dem.h"
#include "ingest/exact_ground_map.h"
#include "ingest/summits.h"

namespace terrview {

// A post's place: in the DEM's own coordinates, and on the Earth where the DEM has a CRS.
struct PostCoordinates {
  glm::dvec2 xy;
  std::optional<GeoPoint> geographic;
};

struct SummitPlace {
  PostCoordinates place;
  float height_m;
};

struct DemInfo {
  std::string crs_name;                   // empty = none
  std::string crs_code;                   // as EPSG:32632; empty = none known
  std::optional<CrsOperation> operation;  // to WGS 84
  glm::dvec2 spacing_m;                   // of the posts in the middle, along rows and columns
  PostCoordinates first_post;             // the north-west one, unless the raster is rotated
  PostCoordinates last_post;              // the one across
  PostCoordinates middle;
  HeightRange range;
  std::vector<SummitPlace> summits;  // the highest, highest first (see ingest/summits.h)
};

inline constexpr std::size_t kListedSummits = 10;

// Throws InputError if the DEM's CRS has no way to WGS 84.
[[nodiscard]] DemInfo describe_dem(const Dem& dem);

}  // namespace terrview

// The coordinate reference system of a DEM, taken apart.
#pragma once

#include <optional>
#include <string>

class OGRSpatialReference;

namespace terrview {

struct DemCrs {
  std::string wkt;          // of the horizontal part, WKT2; empty = flat, in metres
  bool geographic = false;  // in degrees
  std::string vertical_datum;
  std::string height_unit;  // of the vertical part; empty = none said
  double metres_per_unit = 1;
};

// A compound or three-dimensional CRS is split; an engineering (local) CRS in metres is flat
// ground. `where` names the file in errors. Throws InputError where a CRS cannot hold a DEM.
[[nodiscard]] DemCrs split_crs(const OGRSpatialReference& crs, const std::string& where);

// The vertical half alone, over flat ground.
[[nodiscard]] DemCrs vertical_part(const OGRSpatialReference& crs);

// The same as split_crs() for what a user wrote: an EPSG code, PROJ string, WKT. Throws InputError.
[[nodiscard]] DemCrs parse_crs(const std::string& text);

// A CRS's name, and its authority's code for it (EPSG:4326); empty if there is none.
[[nodiscard]] std::string crs_name(const std::string& wkt);
[[nodiscard]] std::string crs_code(const std::string& wkt);

// Whether two CRSs, as split_crs() writes them, are one.
[[nodiscard]] bool same_crs(const std::string& wkt, const std::string& other_wkt);

}  // namespace terrview

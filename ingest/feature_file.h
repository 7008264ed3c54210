// Features with fields to GeoPackage, through GDAL.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include <glm/vec2.hpp>

namespace terrview {

using FieldValue = std::variant<std::monostate, std::int64_t, double, std::string>;  // first: none

enum class FieldType { integer, real, text };

struct Field {
  std::string name;
  FieldType type;
};

enum class FeatureGeometry { none, point, polygons };

struct FeatureRow {
  std::vector<FieldValue> values;  // one for each field
  glm::dvec2 point{0, 0};
  // Closed rings: of each polygon the outer, then its holes.
  std::vector<std::vector<std::vector<glm::dvec2>>> polygons = {};
};

// x of a place is to the east, whatever axis order the coordinate reference system prefers.
struct FeatureLayer {
  std::string name;
  FeatureGeometry geometry = FeatureGeometry::none;
  std::string crs_wkt = {};  // or a name, as EPSG:4326; empty = none
  std::vector<Field> fields;
  std::vector<FeatureRow> rows = {};
};

// The same bytes for the same layers: whatever date the format wants is that of SOURCE_DATE_EPOCH,
// or 1970. Throws std::runtime_error with the reason, but not the path, if writing fails.
void write_geopackage(const std::string& path, const std::vector<FeatureLayer>& layers);

}  // namespace terrview

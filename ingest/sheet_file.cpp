#include "ingest/sheet_file.h"

#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string_view>

#include <ogr_geometry.h>
#include <glm/common.hpp>

#include "ingest/crs_transform.h"
#include "ingest/dem_crs.h"
#include "ingest/vector_file.h"

namespace terrview {
namespace {

struct NamedCorners {
  int number;
  std::string name;
  std::vector<glm::dvec2> corners;
};

NamedCorners corners_of(const VectorFeature& feature, const std::string& field) {
  feature.require_field(field);
  const std::array<std::string_view, 1> fields{field};
  const auto name = feature.text(fields);
  if (!name) feature.refuse("has no name in '" + field + "': give it one, or another field");
  const OGRGeometry* geometry = feature.geometry();
  if (geometry == nullptr || geometry->getDimension() != 2 || geometry->IsEmpty() != 0)
    feature.refuse("is no polygon: give the outline of a sheet");
  NamedCorners named{feature.number(), *name, {}};
  OGREnvelope box;
  geometry->getEnvelope(&box);
  // The middles of the sides too: parallels bend on a map.
  for (const double across : {0.0, 0.5, 1.0}) {
    for (const double up : {0.0, 0.5, 1.0})
      named.corners.emplace_back(box.MinX + across * (box.MaxX - box.MinX),
                                 box.MinY + up * (box.MaxY - box.MinY));
  }
  return named;
}

}  // namespace

std::vector<SheetOutline> read_sheet_outlines(const std::string& path, const std::string& field,
                                              const Dem& dem) {
  std::vector<NamedCorners> sheets;
  const VectorFile file = read_vector_file(
      path, [&](const VectorFeature& feature) { sheets.push_back(corners_of(feature, field)); });
  const bool moved =
      !file.crs_wkt.empty() && !dem.crs_wkt.empty() && !same_crs(file.crs_wkt, dem.crs_wkt);
  std::vector<SheetOutline> outlines;
  for (NamedCorners& sheet : sheets) {
    if (moved) {
      CrsTransform(path, file.crs_wkt, sheet.corners).to_geographic(sheet.corners);
      const glm::dvec2 middle =
          dem.placement.at(glm::dvec2(dem.grid->columns, dem.grid->rows) / 2.0);
      CrsTransform(dem.name, dem.crs_wkt, {&middle, 1}).from_geographic(sheet.corners);
    }
    SheetOutline outline{sheet.number, sheet.name, sheet.corners.front(), sheet.corners.front()};
    for (const glm::dvec2& corner : sheet.corners) {
      outline.low = glm::min(outline.low, corner);
      outline.high = glm::max(outline.high, corner);
    }
    outlines.push_back(outline);
  }
  return outlines;
}

}  // namespace terrview

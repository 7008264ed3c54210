#include "ingest/feature_polygons.h"

#include <cmath>
#include <memory>
#include <utility>

#include <ogr_geometry.h>

#include "ingest/view_checks.h"

namespace terrview {
namespace {

Polygon::Ring ring_of(const VectorFeature& feature, const OGRLinearRing& from) {
  Polygon::Ring ring;
  ring.reserve(static_cast<std::size_t>(from.getNumPoints()));
  for (int i = 0; i < from.getNumPoints(); ++i)
    ring.push_back(checked_corner(feature, from.getX(i), from.getY(i)));
  return ring;
}

void add_polygons(const VectorFeature& feature, const OGRGeometry& geometry,
                  std::vector<std::vector<Polygon::Ring>>& polygons) {
  const OGRwkbGeometryType type = wkbFlatten(geometry.getGeometryType());
  if (type == wkbPolygon) {
    std::vector<Polygon::Ring> rings;
    for (const OGRLinearRing* ring : *geometry.toPolygon())
      rings.push_back(ring_of(feature, *ring));
    if (!rings.empty() && !rings.front().empty()) polygons.push_back(std::move(rings));
  } else if (type == wkbMultiPolygon || type == wkbGeometryCollection) {
    for (const OGRGeometry* part : *geometry.toGeometryCollection())
      add_polygons(feature, *part, polygons);
  } else if (geometry.hasCurveGeometry() != 0) {
    const std::unique_ptr<OGRGeometry> straight(geometry.getLinearGeometry());
    if (straight && straight->hasCurveGeometry() == 0) add_polygons(feature, *straight, polygons);
  }
}

}  // namespace

glm::dvec2 checked_corner(const VectorFeature& feature, double x, double y) {
  // Squares of what is left are numbers.
  constexpr double kFarthest = 1e9;
  if (!(std::abs(x) <= kFarthest && std::abs(y) <= kFarthest))
    feature.refuse("a corner at " + in_words("%g", x) + ", " + in_words("%g", y) +
                   " is nowhere: mend its coordinates");
  return {x, y};
}

std::vector<std::vector<Polygon::Ring>> polygons_of(const VectorFeature& feature) {
  std::vector<std::vector<Polygon::Ring>> polygons;
  if (const OGRGeometry* geometry = feature.geometry()) add_polygons(feature, *geometry, polygons);
  return polygons;
}

}  // namespace terrview

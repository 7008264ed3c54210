#include "ingest/feature_file.h"

#include <cstdlib>
#include <ctime>
#include <memory>
#include <stdexcept>

#include <cpl_conv.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>
#include <ogrsf_frmts.h>

#include "ingest/gdal_scope.h"
#include "ingest/memory_file.h"
#include "render/write_file.h"

namespace terrview {
namespace {

std::string date_text() {
  const char* epoch = std::getenv("SOURCE_DATE_EPOCH");
  const std::time_t time = epoch == nullptr ? 0 : std::strtoll(epoch, nullptr, 10);
  std::tm utc{};
  gmtime_r(&time, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%S.000Z", &utc);
  return text;
}

OGRwkbGeometryType type_of(FeatureGeometry geometry) {
  switch (geometry) {
    case FeatureGeometry::none:
      return wkbNone;
    case FeatureGeometry::point:
      return wkbPoint;
    case FeatureGeometry::polygons:
      return wkbMultiPolygon;
  }
  return wkbNone;
}

OGRFieldType type_of(FieldType type) {
  switch (type) {
    case FieldType::integer:
      return OFTInteger64;
    case FieldType::real:
      return OFTReal;
    case FieldType::text:
      return OFTString;
  }
  return OFTString;
}

std::unique_ptr<OGRGeometry> geometry_of(const FeatureRow& row, FeatureGeometry kind) {
  if (kind == FeatureGeometry::point) return std::make_unique<OGRPoint>(row.point.x, row.point.y);
  auto polygons = std::make_unique<OGRMultiPolygon>();
  for (const auto& rings : row.polygons) {
    auto polygon = std::make_unique<OGRPolygon>();
    for (const auto& places : rings) {
      auto ring = std::make_unique<OGRLinearRing>();
      for (const glm::dvec2 at : places) ring->addPoint(at.x, at.y);
      polygon->addRingDirectly(ring.release());
    }
    polygons->addGeometryDirectly(polygon.release());
  }
  return polygons;
}

void set_field(OGRFeature& feature, int index, const FieldValue& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value))
    feature.SetField(index, static_cast<GIntBig>(*whole));
  else if (const auto* real = std::get_if<double>(&value))
    feature.SetField(index, *real);
  else if (const auto* text = std::get_if<std::string>(&value))
    feature.SetField(index, text->c_str());
}

void write_layer(GDALDataset& dataset, const FeatureLayer& from, GdalScope& gdal) {
  OGRSpatialReference crs;
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const bool has_crs = !from.crs_wkt.empty();
  if (has_crs && crs.SetFromUserInput(from.crs_wkt.c_str()) != OGRERR_NONE) gdal.throw_failure();
  OGRLayer* layer = dataset.CreateLayer(from.name.c_str(), has_crs ? &crs : nullptr,
                                        type_of(from.geometry), nullptr);
  if (layer == nullptr) gdal.throw_failure();
  for (const Field& field : from.fields) {
    OGRFieldDefn definition(field.name.c_str(), type_of(field.type));
    if (layer->CreateField(&definition) != OGRERR_NONE) gdal.throw_failure();
  }
  for (const FeatureRow& row : from.rows) {
    OGRFeature feature(layer->GetLayerDefn());
    for (std::size_t i = 0; i < row.values.size(); ++i)
      set_field(feature, static_cast<int>(i), row.values[i]);
    if (from.geometry != FeatureGeometry::none)
      feature.SetGeometryDirectly(geometry_of(row, from.geometry).release());
    if (layer->CreateFeature(&feature) != OGRERR_NONE) gdal.throw_failure();
  }
}

}  // namespace

void write_geopackage(const std::string& path, const std::vector<FeatureLayer>& layers) {
  GdalScope gdal;
  const CPLConfigOptionSetter date("OGR_CURRENT_DATE", date_text().c_str(), false);
  const MemoryName memory(".gpkg");
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GPKG");
  if (driver == nullptr) throw std::runtime_error("this GDAL writes no GeoPackage");
  GDALDatasetUniquePtr dataset(
      driver->Create(memory.path().c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  if (!dataset) gdal.throw_failure();
  for (const FeatureLayer& layer : layers) write_layer(*dataset, layer, gdal);
  dataset.reset();
  if (const std::string failure = gdal.take_failure(); !failure.empty())
    throw std::runtime_error(failure);
  write_file(path, memory.bytes());
}

}  // namespace terrview

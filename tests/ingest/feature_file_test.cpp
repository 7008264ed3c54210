// One test per promise of ingest/feature_file.h.
#include "ingest/feature_file.h"

#include <ogrsf_frmts.h>

#include <chrono>
#include <thread>

#include "tests/ingest/test_raster.h"

namespace terrview {
namespace {

std::vector<FeatureLayer> two_layers() {
  FeatureLayer places{
      .name = "places",
      .geometry = FeatureGeometry::point,
      .crs_wkt = "EPSG:4326",
      .fields = {
          {"name", FieldType::text}, {"count", FieldType::integer}, {"share", FieldType::real}}};
  places.rows.push_back({{"Aäß <b>", std::int64_t{5'000'000'000}, 0.125}, {7, 48}});
  places.rows.push_back({{{}, {}, {}}, {8, 47}});
  FeatureLayer blocks{.name = "blocks",
                      .geometry = FeatureGeometry::polygons,
                      .fields = {{"number", FieldType::integer}}};
  // A triangle, and a square with a courtyard.
  blocks.rows.push_back({.values = {std::int64_t{1}},
                         .polygons = {{{{0, 0}, {1, 0}, {1, 1}, {0, 0}}},
                                      {{{2, 0}, {6, 0}, {6, 4}, {2, 4}, {2, 0}},
                                       {{3, 1}, {3, 3}, {5, 3}, {5, 1}, {3, 1}}}}});
  const FeatureLayer table{
      .name = "table", .fields = {{"x", FieldType::real}}, .rows = {{{1.5}}, {{FieldValue()}}}};
  return {places, blocks, table};
}

TEST(FeatureFile, KeepsLayersFieldsAndPlaces) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.gpkg";
  write_geopackage(path, two_layers());
  const GDALDatasetUniquePtr dataset(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR));
  ASSERT_TRUE(dataset);
  ASSERT_EQ(dataset->GetLayerCount(), 3);
  OGRLayer& places = *dataset->GetLayerByName("places");
  EXPECT_STREQ(places.GetSpatialRef()->GetAuthorityCode(nullptr), "4326");
  const OGRFeatureUniquePtr first(places.GetNextFeature());
  EXPECT_STREQ(first->GetFieldAsString("name"), "Aäß <b>");
  EXPECT_EQ(first->GetFieldAsInteger64("count"), 5'000'000'000);
  EXPECT_EQ(first->GetFieldAsDouble("share"), 0.125);
  EXPECT_EQ(first->GetGeometryRef()->toPoint()->getX(), 7);
  const OGRFeatureUniquePtr second(places.GetNextFeature());
  EXPECT_TRUE(second->IsFieldNull(0) || !second->IsFieldSet(0));
  const OGRFeatureUniquePtr block(dataset->GetLayerByName("blocks")->GetNextFeature());
  EXPECT_EQ(OGR_G_Area(OGRGeometry::ToHandle(block->GetGeometryRef())), 0.5 + 16 - 4);
  EXPECT_TRUE(block->GetGeometryRef()->IsValid());
  EXPECT_EQ(dataset->GetLayerByName("table")->GetFeatureCount(), 2);
  EXPECT_EQ(dataset->GetLayerByName("table")->GetGeomType(), wkbNone);
}

TEST(FeatureFile, HasTheSameBytesASecondLater) {
  const TemporaryFolder folder;
  write_geopackage(folder / "a.gpkg", two_layers());
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));
  write_geopackage(folder / "b.gpkg", two_layers());
  EXPECT_TRUE(read_text(folder / "a.gpkg") == read_text(folder / "b.gpkg"));
  EXPECT_EQ(names_in(folder.path()), (std::set<std::string>{"a.gpkg", "b.gpkg"}));
}

}  // namespace
}  // namespace terrview

// One test per promise of ingest/dem.h about where posts lie.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/ingest/test_raster.h"

namespace terrview {
namespace {

class DemPlacement : public testing::Test {
 protected:
  TemporaryFolder folder_;
};

void expect_near(glm::dvec2 actual, glm::dvec2 expected) {
  EXPECT_NEAR(actual.x, expected.x, 1e-9);
  EXPECT_NEAR(actual.y, expected.y, 1e-9);
}

TEST_F(DemPlacement, APostIsThePixelsCentre) {
  const Dem dem = read_one(TestRaster{}.write(folder_ / "a.tif"));
  expect_near(dem.placement.at({0, 0}), {400025, 5299975});
  expect_near(dem.placement.at({4, 3}), {400225, 5299825});
  EXPECT_EQ(dem.grid->at(4, 3), 143);
}

TEST_F(DemPlacement, PixelIsPointSaysTheSameThing) {
  TestRaster raster;
  raster.metadata = {{"AREA_OR_POINT", "Point"}};
  const Dem dem = read_one(raster.write(folder_ / "a.tif"));
  expect_near(dem.placement.at({0, 0}), {400025, 5299975});
}

TEST_F(DemPlacement, GridsStoredFromSouthOrFromEastReadLikeTheOthers) {
  TestRaster south;
  south.geotransform = {{400000, 50, 0, 5299800, 0, 50}};
  south.number = [](int column, int row) { return 100.0 + 10 * column + (3 - row); };
  TestRaster east;
  east.geotransform = {{400250, -50, 0, 5300000, 0, -50}};
  east.number = [](int column, int row) { return 100.0 + 10 * (4 - column) + row; };
  const Dem plain = read_one(TestRaster{}.write(folder_ / "plain.tif"));
  for (const TestRaster& flipped : {south, east}) {
    const Dem dem = read_one(flipped.write(folder_ / "flipped.tif"));
    EXPECT_EQ(dem.grid->heights_m, plain.grid->heights_m);
    EXPECT_EQ(dem.placement.origin, plain.placement.origin);
    EXPECT_EQ(dem.placement.step, plain.placement.step);
  }
}

TEST_F(DemPlacement, ARotatedGridLiesWhereItsFileSays) {
  TestRaster raster;
  raster.geotransform = {{400000, 40, 30, 5300000, 30, -40}};
  const Dem dem = read_one(raster.write(folder_ / "a.tif"));
  expect_near(dem.placement.at({2, 1}),
              {400000 + 40 * 2.5 + 30 * 1.5, 5300000 + 30 * 2.5 - 40 * 1.5});
  EXPECT_EQ(dem.grid->at(2, 1), 121);
}

TEST_F(DemPlacement, AWindowKeepsItsPostsInPlace) {
  DemOptions options;
  options.window = {1, 2, 3, 2};
  TestRaster south;
  south.geotransform = {{400000, 50, 0, 5299800, 0, 50}};
  for (const TestRaster& raster : {TestRaster{}, south}) {
    const std::string path = raster.write(folder_ / "a.tif");
    const Dem whole = read_one(path);
    const Dem part = read_one(path, options);
    ASSERT_EQ(part.grid->columns, 3);
    ASSERT_EQ(part.grid->rows, 2);
    const int first_row = raster.geotransform == TestRaster{}.geotransform ? 2 : 0;
    expect_near(part.placement.at({0, 0}), whole.placement.at({1, first_row}));
    EXPECT_EQ(part.grid->at(0, 0), whole.grid->at(1, first_row));
    EXPECT_EQ(part.grid->at(2, 1), whole.grid->at(3, first_row + 1));
  }
}

TEST_F(DemPlacement, AWindowBeyondTheFileIsRefused) {
  const std::string path = TestRaster{}.write(folder_ / "a.tif");
  DemOptions options;
  for (const PostWindow& window :
       {PostWindow{-1, 0, 3, 3}, {0, 0, 6, 4}, {0, 3, 5, 2}, {0, 0, 0, 4}, {2147483647, 0, 2, 2}}) {
    options.window = window;
    EXPECT_TRUE(says(refusal({path}, options), {path + ": --window"}));
  }
}

TEST_F(DemPlacement, SpacingPutsTheSouthWestPostAtZeroWithoutACrs) {
  TestRaster bare;
  bare.geotransform.reset();
  bare.crs.clear();
  TestRaster south;
  south.geotransform = {{400000, 50, 0, 5299800, 0, 50}};
  DemOptions options;
  options.spacing = glm::dvec2(60, 90);
  for (const TestRaster& raster : {bare, TestRaster{}, south}) {
    const Dem dem = read_one(raster.write(folder_ / "a.tif"), options);
    expect_near(dem.placement.at({0, 3}), {0, 0});
    expect_near(dem.placement.at({4, 0}), {240, 270});
    EXPECT_EQ(dem.crs_wkt, "");
  }
}

TEST_F(DemPlacement, SpacingOfAWindowCountsFromTheWholeFile) {
  DemOptions options;
  options.spacing = glm::dvec2(60, 90);
  options.window = {2, 0, 3, 2};
  const Dem dem = read_one(TestRaster{}.write(folder_ / "a.tif"), options);
  expect_near(dem.placement.at({0, 1}), {120, 180});
}

TEST_F(DemPlacement, RastersWithoutAPlaceAreRefusedWithARemedy) {
  TestRaster raster;
  raster.geotransform.reset();
  const std::string bare = raster.write(folder_ / "bare.tif");
  EXPECT_TRUE(says(refusal({bare}), {"--spacing"}));
  raster.metadata.clear();
  raster.change = [](GDALDataset& dataset) {
    std::array<GDAL_GCP, 3> points{};
    GDALInitGCPs(3, points.data());
    for (int i = 0; i < 3; ++i) {
      auto& point = points[static_cast<std::size_t>(i)];
      point.dfGCPPixel = i * 2;
      point.dfGCPLine = i * i;
      point.dfGCPX = 400000 + i;
      point.dfGCPY = 5300000 - i;
    }
    dataset.SetGCPs(3, points.data(), dataset.GetSpatialRef());
    GDALDeinitGCPs(3, points.data());
  };
  EXPECT_TRUE(says(refusal({raster.write(folder_ / "gcp.tif")}), {"gdalwarp"}));
}

TEST_F(DemPlacement, AVrtWithACameraModelIsRefusedWithARemedy) {
  const std::string path = folder_ / "rpc.vrt";
  write_text(path,
             "<VRTDataset rasterXSize='4' rasterYSize='4'><Metadata domain='RPC'>"
             "<MDI key='LINE_OFF'>1</MDI></Metadata>"
             "<VRTRasterBand dataType='Byte' band='1'/></VRTDataset>");
  EXPECT_TRUE(says(refusal({path}), {"gdalwarp"}));
}

TEST_F(DemPlacement, APlacementThatIsNoneIsRefused) {
  const std::string path = folder_ / "flat.vrt";
  for (const char* transform : {"0,0,0,0,0,0", "0,1,1,0,1,1", "nan,1,0,0,0,1", "0,inf,0,0,0,1"}) {
    write_text(path, std::string("<VRTDataset rasterXSize='4' rasterYSize='4'><GeoTransform>") +
                         transform +
                         "</GeoTransform><VRTRasterBand dataType='Byte' band='1'/></VRTDataset>");
    EXPECT_TRUE(says(refusal({path}), {"--spacing"})) << transform;
  }
}

TEST_F(DemPlacement, TheHeaderTellsThePlaceWithoutReading) {
  const std::string path = TestRaster{}.write(folder_ / "a.tif");
  const DemHeader header = read_dem_header(path);
  EXPECT_EQ(header.columns, 5);
  EXPECT_EQ(header.rows, 4);
  expect_near(header.placement.at({0, 0}), {400025, 5299975});
  EXPECT_TRUE(says(header.crs_wkt, {"UTM zone 32N"}));
  EXPECT_FALSE(header.geographic);
}

TEST_F(DemPlacement, TheCallerMayChooseAPartOfEachFileByItsHeader) {
  const std::string first = TestRaster{}.write(folder_ / "a.tif");
  TestRaster elsewhere;
  elsewhere.geotransform = {{900000, 50, 0, 5300000, 0, -50}};
  const std::string second = elsewhere.write(folder_ / "b.tif");
  DemOptions options;
  options.choose_window = [](const DemHeader& header) -> std::optional<PostWindow> {
    if (header.placement.origin.x > 500000) return std::nullopt;
    return PostWindow{0, 0, 2, 3};
  };
  const auto dems = read_dems({first, second}, options);
  ASSERT_EQ(dems.size(), 1U);
  EXPECT_EQ(dems[0].grid->columns, 2);
  EXPECT_TRUE(says(refusal({second}, options), {"no DEM"}));
}

}  // namespace
}  // namespace terrview

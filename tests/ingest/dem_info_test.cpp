// One test per promise of ingest/dem_info.h and ingest/summits.h.
#include "ingest/dem_info.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "terrain/error.h"
#include "tests/ingest/test_raster.h"

namespace terrview {
namespace {

HeightGrid make_plain(int columns, int rows) {
  return {columns, rows, std::vector<float>(static_cast<std::size_t>(columns * rows), 100)};
}

void raise(HeightGrid& grid, glm::ivec2 post, float height_m) {
  grid.heights_m[static_cast<std::size_t>(post.y * grid.columns + post.x)] = height_m;
}

TEST(Summits, TheHighestComeFirst) {
  HeightGrid grid = make_plain(200, 160);  // reach 4
  raise(grid, {20, 30}, 500);
  raise(grid, {150, 100}, 900);
  raise(grid, {60, 140}, 700);
  const auto summits = find_summits(grid, 2);
  ASSERT_EQ(summits.size(), 2U);
  EXPECT_EQ(summits[0].post, glm::ivec2(150, 100));
  EXPECT_EQ(summits[0].height_m, 900);
  EXPECT_EQ(summits[1].post, glm::ivec2(60, 140));
}

TEST(Summits, ShouldersWithinReachOfAHigherPostAreNone) {
  for (const glm::ivec2 away : {glm::ivec2(4, 0), {0, -4}, {-4, 4}, {3, 3}}) {
    HeightGrid grid = make_plain(200, 160);
    raise(grid, {80, 80}, 900);
    raise(grid, glm::ivec2(80, 80) + away, 890);
    EXPECT_EQ(find_summits(grid, 10).size(), 1U);
  }
  HeightGrid grid = make_plain(200, 160);
  raise(grid, {80, 80}, 900);
  raise(grid, {85, 80}, 890);
  EXPECT_EQ(find_summits(grid, 10).size(), 2U);
}

TEST(Summits, OfEqualPostsTheFirstIsTheSummit) {
  HeightGrid grid = make_plain(200, 160);
  for (const glm::ivec2 post : {glm::ivec2(81, 80), {80, 81}, {81, 81}}) raise(grid, post, 900);
  const auto summits = find_summits(grid, 10);
  ASSERT_EQ(summits.size(), 1U);
  EXPECT_EQ(summits[0].post, glm::ivec2(81, 80));
}

TEST(Summits, ThePlainTheBorderAndTheEdgeOfAVoidHaveNone) {
  HeightGrid grid = make_plain(200, 160);
  EXPECT_TRUE(find_summits(grid, 10).empty());
  raise(grid, {0, 80}, 900);
  raise(grid, {80, 159}, 900);
  raise(grid, {100, 100}, 900);
  raise(grid, {101, 101}, std::numeric_limits<float>::quiet_NaN());
  EXPECT_TRUE(find_summits(grid, 10).empty());
}

class DemInfoTest : public testing::Test {
 protected:
  TemporaryFolder folder_;
};

TEST_F(DemInfoTest, APlacedDemIsDescribedOnTheEarth) {
  TestRaster raster;
  raster.columns = raster.rows = 101;
  raster.geotransform = {{7 - 0.05, 0.001, 0, 48 + 0.05, 0, -0.001}};
  raster.crs = "EPSG:4326";
  raster.number = [](int column, int row) { return column == 70 && row == 20 ? 900 : 300; };
  const DemInfo info = describe_dem(read_one(raster.write(folder_ / "a.tif")));
  EXPECT_EQ(info.crs_name, "WGS 84");
  EXPECT_EQ(info.crs_code, "EPSG:4326");
  ASSERT_TRUE(info.operation);
  // A degree on the WGS 84 ellipsoid at 48 N: 74.63 km along the parallel, 111.20 km north.
  EXPECT_NEAR(info.spacing_m.x, 74.63, 0.01);
  EXPECT_NEAR(info.spacing_m.y, 111.20, 0.01);
  EXPECT_EQ(info.range.lowest_m, 300);
  EXPECT_EQ(info.range.highest_m, 900);
  ASSERT_EQ(info.summits.size(), 1U);
  EXPECT_EQ(info.summits[0].height_m, 900);
  ASSERT_TRUE(info.summits[0].place.geographic);
  EXPECT_NEAR(info.summits[0].place.geographic->longitude_deg, 7.0205, 1e-9);
  EXPECT_NEAR(info.summits[0].place.geographic->latitude_deg, 48.0295, 1e-9);
  EXPECT_NEAR(info.first_post.geographic->latitude_deg, 48.0495, 1e-9);
  EXPECT_NEAR(info.last_post.geographic->latitude_deg, 47.9495, 1e-9);
  EXPECT_NEAR(info.middle.geographic->longitude_deg, 7.0005, 1e-9);
}

TEST_F(DemInfoTest, TheOperationsAccuracyIsThatOfProj) {
  TestRaster raster;
  raster.crs = "EPSG:27700";
  raster.geotransform = {{210000, 50, 0, 780000, 0, -50}};
  const DemInfo info = describe_dem(read_one(raster.write(folder_ / "a.tif")));
  EXPECT_EQ(info.crs_code, "EPSG:27700");
  ASSERT_TRUE(info.operation && info.operation->accuracy_m);
  EXPECT_GT(*info.operation->accuracy_m, 0);
  EXPECT_LE(*info.operation->accuracy_m, 5);
}

TEST_F(DemInfoTest, AFlatDemIsDescribedInItsOwnUnits) {
  TestRaster raster;
  raster.crs.clear();
  raster.geotransform = {{1000, 3, 0, 2000, 0, -4}};
  const DemInfo info = describe_dem(read_one(raster.write(folder_ / "a.tif")));
  EXPECT_EQ(info.crs_name, "");
  EXPECT_FALSE(info.operation);
  EXPECT_EQ(info.spacing_m, glm::dvec2(3, 4));
  EXPECT_FALSE(info.middle.geographic);
  EXPECT_EQ(info.first_post.xy, glm::dvec2(1001.5, 1998));
}

TEST_F(DemInfoTest, TheSummitsOfTheVosgesAreFound) {
  NEEDS_SHARED_DATA();
  const std::string path = shared_data("vosges/vosges_hohneck_grandballon_256.tif");
  const DemInfo info = describe_dem(read_one(path));
  ASSERT_EQ(info.summits.size(), kListedSummits);
  // Grand Ballon, 1424 m.
  EXPECT_NEAR(info.summits[0].place.geographic->latitude_deg, 47.9008, 0.002);
  EXPECT_NEAR(info.summits[0].place.geographic->longitude_deg, 7.0986, 0.002);
  EXPECT_NEAR(info.summits[0].height_m, 1424, 20);
}

}  // namespace
}  // namespace terrview

// One test per promise of ingest/dem.h about several files.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/ingest/test_raster.h"

namespace terrview {
namespace {

class DemJoin : public testing::Test {
 protected:
  // A window of one wide landscape.
  std::string write_tile(const std::string& name, glm::ivec2 first, glm::ivec2 size) {
    TestRaster raster;
    raster.columns = size.x;
    raster.rows = size.y;
    raster.nodata = -1;
    raster.geotransform = {{400000 + 50.0 * first.x, 50, 0, 5300000 - 50.0 * first.y, 0, -50}};
    raster.number = [=, this](int column, int row) {
      return landscape(first + glm::ivec2(column, row));
    };
    return raster.write(folder_ / name);
  }

  std::function<double(glm::ivec2)> landscape = [](glm::ivec2 post) {
    return 1000.0 + (post.x * 37 + post.y * 91) % 400;
  };
  TemporaryFolder folder_;
};

TEST_F(DemJoin, TilesBecomeOneGridWhetherTheyShareABorderOrAbut) {
  const std::string west = write_tile("west.tif", {0, 0}, {20, 30});
  for (const int first : {19, 20}) {
    const std::string east = write_tile("east.tif", {first, 0}, {20, 30});
    const Dem whole = read_one(write_tile("whole.tif", {0, 0}, {first + 20, 30}));
    const auto dems = read_dems({west, east});
    ASSERT_EQ(dems.size(), 1U);
    EXPECT_EQ(dems[0].grid->heights_m, whole.grid->heights_m);
    EXPECT_EQ(dems[0].placement.origin, whole.placement.origin);
    EXPECT_EQ(dems[0].name, west + " + " + east);
  }
}

TEST_F(DemJoin, TheFirstFileWinsWhereItHasAHeight) {
  landscape = [](glm::ivec2 post) { return post.x == 9 && post.y == 3 ? -1 : 100; };
  const std::string first = write_tile("first.tif", {0, 0}, {10, 10});
  landscape = [](glm::ivec2) { return 200; };
  const std::string second = write_tile("second.tif", {8, 0}, {10, 10});
  const Dem dem = read_dems({first, second}).at(0);
  EXPECT_EQ(dem.grid->at(9, 2), 100);
  EXPECT_EQ(dem.grid->at(9, 3), 200);
  EXPECT_EQ(dem.grid->at(10, 2), 200);
  EXPECT_EQ(read_dems({second, first}).at(0).grid->at(9, 2), 200);
}

TEST_F(DemJoin, AVoidAcrossTheSeamIsFilled) {
  landscape = [](glm::ivec2 post) {
    return post.x >= 17 && post.x < 23 && post.y >= 10 && post.y < 14 ? -1 : 500;
  };
  const std::string west = write_tile("west.tif", {0, 0}, {20, 30});
  const std::string east = write_tile("east.tif", {20, 0}, {20, 30});
  const Dem dem = read_dems({west, east}).at(0);
  EXPECT_EQ(dem.voids_filled, 24U);
  EXPECT_EQ(dem.voids_open, 0U);
  EXPECT_EQ(dem.grid->at(20, 12), 500);
}

TEST_F(DemJoin, VoidsStayOpenOnRequest) {
  landscape = [](glm::ivec2 post) { return post == glm::ivec2(5, 5) ? -1 : 500; };
  DemOptions options;
  options.fill_voids = false;
  const Dem dem = read_one(write_tile("a.tif", {0, 0}, {20, 30}), options);
  EXPECT_EQ(dem.voids_filled, 0U);
  EXPECT_EQ(dem.voids_open, 1U);
}

TEST_F(DemJoin, WhatNoTileCoversIsNoVoid) {
  const std::string corner = write_tile("a.tif", {0, 0}, {40, 40});
  const std::string east = write_tile("b.tif", {40, 0}, {40, 40});
  const std::string south = write_tile("c.tif", {0, 39}, {40, 40});
  const Dem dem = read_dems({corner, east, south}).at(0);
  EXPECT_EQ(dem.grid->columns, 80);
  EXPECT_EQ(dem.grid->rows, 79);
  EXPECT_EQ(dem.voids_open, 0U);
  EXPECT_TRUE(std::isnan(dem.grid->at(60, 60)));
}

TEST_F(DemJoin, FilesOfOtherLatticesKeepTheirOrder) {
  const std::string west = write_tile("west.tif", {0, 0}, {20, 30});
  const std::string east = write_tile("east.tif", {20, 0}, {20, 30});
  TestRaster finer;
  finer.geotransform = {{400100, 10, 0, 5299900, 0, -10}};
  const std::string fine = finer.write(folder_ / "fine.tif");
  const auto dems = read_dems({fine, west, east});
  ASSERT_EQ(dems.size(), 2U);
  EXPECT_EQ(dems[0].name, fine);
  EXPECT_EQ(dems[1].grid->columns, 40);
}

TEST_F(DemJoin, TilesStoredUpsideDownJoinTheOthers) {
  const std::string north = write_tile("north.tif", {0, 0}, {20, 30});
  TestRaster south;
  south.columns = 20;
  south.rows = 30;
  south.geotransform = {{400000, 50, 0, 5300000 - 50.0 * 60, 0, 50}};
  south.number = [this](int column, int row) { return landscape({column, 59 - row}); };
  const auto dems = read_dems({north, south.write(folder_ / "south.tif")});
  ASSERT_EQ(dems.size(), 1U);
  EXPECT_EQ(dems[0].grid->heights_m,
            read_one(write_tile("whole.tif", {0, 0}, {20, 60})).grid->heights_m);
}

bool same_heights(const HeightGrid& a, const HeightGrid& b) {
  return std::equal(a.heights_m.begin(), a.heights_m.end(), b.heights_m.begin(), b.heights_m.end(),
                    [](float x, float y) { return x == y || (std::isnan(x) && std::isnan(y)); });
}

TEST_F(DemJoin, RealTilesEqualTheMosaicOfGdalbuildvrt) {
  NEEDS_SHARED_DATA();
  for (const auto& [first, second] : {std::pair{"vosges/N47E007.hgt", "vosges/N48E007.hgt"},
                                      {"osterrain50/NN16.asc", "osterrain50/NN17.asc"}}) {
    const std::vector<std::string> paths{shared_data(first), shared_data(second)};
    const auto joined = read_dems(paths);
    ASSERT_EQ(joined.size(), 1U);
    const Dem expected = read_one(build_vrt(folder_ / "mosaic.vrt", {paths[1], paths[0]}));
    EXPECT_TRUE(same_heights(*joined[0].grid, *expected.grid)) << first;
    EXPECT_EQ(joined[0].voids_filled, expected.voids_filled);
    EXPECT_NEAR(joined[0].placement.origin.x, expected.placement.origin.x, 1e-9);
    EXPECT_NEAR(joined[0].placement.origin.y, expected.placement.origin.y, 1e-9);
  }
}

}  // namespace
}  // namespace terrview

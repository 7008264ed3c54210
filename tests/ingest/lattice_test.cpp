// One test per promise of ingest/lattice.h.
#include "ingest/lattice.h"

#include <gtest/gtest.h>

namespace terrview {
namespace {

// A tile whose north-west post is `column`, `row` posts of 1/1200 degree from (7 E, 49 N).
LatticeTile tile_at(double column, double row, int columns = 11, int rows = 11) {
  const double step = 1.0 / 1200;
  return {columns, rows, {{7 + column * step, 49 - row * step}, {step, 0, 0, -step}}, 0, true};
}

TEST(Lattice, TilesThatShareTheirBorderPostsAreJoined) {
  const auto mosaics = join_tiles({tile_at(10, 0), tile_at(0, 0)});
  ASSERT_EQ(mosaics.size(), 1U);
  EXPECT_EQ(mosaics[0].columns, 21);
  EXPECT_EQ(mosaics[0].rows, 11);
  ASSERT_EQ(mosaics[0].parts.size(), 2U);
  EXPECT_EQ(mosaics[0].parts[0].tile, 0);
  EXPECT_EQ(mosaics[0].parts[0].first, glm::ivec2(10, 0));
  EXPECT_EQ(mosaics[0].parts[1].first, glm::ivec2(0, 0));
  EXPECT_NEAR(mosaics[0].placement.origin.x, 7, 1e-12);
}

TEST(Lattice, TilesOneStepApartAreJoined) {
  const auto mosaics = join_tiles({tile_at(0, 0), tile_at(0, 11)});
  ASSERT_EQ(mosaics.size(), 1U);
  EXPECT_EQ(mosaics[0].rows, 22);
  EXPECT_EQ(mosaics[0].parts[1].first, glm::ivec2(0, 11));
}

TEST(Lattice, TilesApartOrAtACornerStayAlone) {
  EXPECT_EQ(join_tiles({tile_at(0, 0), tile_at(0, 12)}).size(), 2U);
  EXPECT_EQ(join_tiles({tile_at(0, 0), tile_at(10, 10)}).size(), 2U);
  EXPECT_EQ(join_tiles({tile_at(0, 0), tile_at(11, 11)}).size(), 2U);
}

TEST(Lattice, AnotherLatticeOrCrsStaysAlone) {
  EXPECT_EQ(join_tiles({tile_at(0, 0), tile_at(10.01, 0)}).size(), 2U);
  EXPECT_EQ(join_tiles({tile_at(0, 0), tile_at(10.0005, 0)}).size(), 1U);
  LatticeTile finer = tile_at(10, 0);
  finer.placement.step /= 2;
  EXPECT_EQ(join_tiles({tile_at(0, 0), finer}).size(), 2U);
  LatticeTile drifting = tile_at(10, 0);
  drifting.placement.step *= 1 + 2e-4;  // 0.002 posts over ten
  EXPECT_EQ(join_tiles({tile_at(0, 0), drifting}).size(), 2U);
  LatticeTile flipped = tile_at(10, 10);
  flipped.placement.step[1] = -flipped.placement.step[1];
  EXPECT_EQ(join_tiles({tile_at(0, 0), flipped}).size(), 2U);
  LatticeTile foreign = tile_at(10, 0);
  foreign.crs = 1;
  EXPECT_EQ(join_tiles({tile_at(0, 0), foreign}).size(), 2U);
}

TEST(Lattice, TilesThatMeetThroughAThirdAreOneGrid) {
  const auto mosaics = join_tiles({tile_at(0, 0), tile_at(20, 0), tile_at(10, 0)});
  ASSERT_EQ(mosaics.size(), 1U);
  EXPECT_EQ(mosaics[0].columns, 31);
  ASSERT_EQ(mosaics[0].parts.size(), 3U);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(mosaics[0].parts[static_cast<std::size_t>(i)].tile, i);
}

TEST(Lattice, MosaicsComeInTheOrderOfTheirFirstTiles) {
  const auto mosaics =
      join_tiles({tile_at(500, 0), tile_at(0, 0), tile_at(510, 0), tile_at(0, 10)});
  ASSERT_EQ(mosaics.size(), 2U);
  EXPECT_EQ(mosaics[0].parts[0].tile, 0);
  EXPECT_EQ(mosaics[0].parts[1].tile, 2);
  EXPECT_EQ(mosaics[1].parts[0].tile, 1);
  EXPECT_EQ(mosaics[1].parts[1].tile, 3);
}

TEST(Lattice, TilesAreJoinedAcrossTheAntimeridian) {
  LatticeTile west = tile_at(0, 0);
  west.placement.origin.x = 180 - 10.0 / 1200;
  LatticeTile east = tile_at(0, 0);
  east.placement.origin.x = -180;
  for (const auto& tiles : {std::vector{west, east}, std::vector{east, west}}) {
    const auto mosaics = join_tiles(tiles);
    ASSERT_EQ(mosaics.size(), 1U);
    EXPECT_EQ(mosaics[0].columns, 21);
  }
  west.geographic = east.geographic = false;
  EXPECT_EQ(join_tiles({west, east}).size(), 2U);
}

TEST(Lattice, AStaircaseIsNotJoinedIntoAMostlyEmptyGrid) {
  std::vector<LatticeTile> stairs;
  for (int i = 0; i < 20; ++i) stairs.push_back(tile_at(10 * i, 5 * i));
  for (int i = 0; i < 20; ++i) stairs.push_back(tile_at(10 * i, 200 - 5 * i));
  std::size_t tiles = 0;
  bool warned = false;
  for (const Mosaic& mosaic : join_tiles(stairs)) {
    double posts = 0;
    for (const Mosaic::Part& part : mosaic.parts) {
      posts += 121;
      EXPECT_GE(part.first.x, 0);
      EXPECT_LE(part.first.x + 11, mosaic.columns);
      EXPECT_GE(part.first.y, 0);
      EXPECT_LE(part.first.y + 11, mosaic.rows);
    }
    EXPECT_LE(static_cast<double>(mosaic.columns) * mosaic.rows, kMostWaste * posts);
    tiles += mosaic.parts.size();
    warned = warned || mosaic.stopped_by_waste;
  }
  EXPECT_EQ(tiles, 40U);
  EXPECT_TRUE(warned);
}

TEST(Lattice, RotatedTilesAreJoinedToo) {
  LatticeTile first = tile_at(0, 0);
  first.placement.step = {0.8, 0.6, 0.6, -0.8};
  LatticeTile second = first;
  second.placement.origin = first.placement.at({0, 11});
  const auto mosaics = join_tiles({first, second});
  ASSERT_EQ(mosaics.size(), 1U);
  EXPECT_EQ(mosaics[0].rows, 22);
}

}  // namespace
}  // namespace terrview

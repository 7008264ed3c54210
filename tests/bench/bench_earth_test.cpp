// One test per promise in bench/bench_earth.h.
#include "bench/bench_earth.h"

#include <gtest/gtest.h>

#include <cmath>

namespace terrview {
namespace {

int pieces_to_the_north(const Terrain& terrain) {
  const GroundMap& map = *terrain.layers()[0].map;
  const GroundLine line{{0, 0}, {std::sqrt(0.5), std::sqrt(0.5)}};
  int pieces = 0;
  // As far as the grid goes, and no further.
  const double to_m = terrain.reach_m() / 2;
  for (double at_m = 0; at_m < to_m; ++pieces) at_m = map.piece_end_m(line, at_m, to_m);
  return pieces;
}

class OnEarth : public testing::TestWithParam<BenchEarth> {};

TEST_P(OnEarth, TheEyeSeesTheGroundBelowItWhereItIs) {
  const BenchDem dem = synthetic_mountains(129);
  for (const BenchView& view : six_views(dem, {8, 8})) {
    const auto terrain =
        terrain_on(GetParam(), dem, view, SurfaceModel::hyperboloid, Search::pyramid);
    const auto hit = terrain->first_hit({{0, 0, 0}, {0, 0, -1}});
    ASSERT_TRUE(hit) << view.name;
    EXPECT_NEAR(hit->distance_m, view.eye_m.z - dem.height_m(view.eye_uv), 0.1) << view.name;
    EXPECT_NEAR(hit->uv.x, view.eye_uv.x, 1e-6);
    EXPECT_NEAR(hit->uv.y, view.eye_uv.y, 1e-6);
  }
}

INSTANTIATE_TEST_SUITE_P(Earths, OnEarth,
                         testing::Values(BenchEarth::flat, BenchEarth::curved, BenchEarth::bent));

TEST(TerrainOn, TracksAreStraightOnAFlatEarthAndAllButSoInUtmAndBendInLatitudesAndLongitudes) {
  const BenchDem dem = synthetic_mountains(1025);
  const BenchView view = six_views(dem, {8, 8})[2];
  const auto pieces = [&](BenchEarth earth) {
    return pieces_to_the_north(
        *terrain_on(earth, dem, view, SurfaceModel::hyperboloid, Search::pyramid));
  };
  EXPECT_EQ(pieces(BenchEarth::flat), 1);
  EXPECT_EQ(pieces(BenchEarth::curved), 1);
  EXPECT_GE(pieces(BenchEarth::bent), 3);
}

TEST(TerrainOn, ACurvedEarthDropsAway) {
  const BenchDem dem = synthetic_mountains(129);
  const BenchView view = six_views(dem, {8, 8})[0];
  for (const BenchEarth earth : {BenchEarth::curved, BenchEarth::bent}) {
    const auto terrain = terrain_on(earth, dem, view, SurfaceModel::hyperboloid, Search::pyramid);
    EXPECT_NEAR(1 / terrain->frame().north_curvature_per_m, 6.37e6, 3e4);
    EXPECT_EQ(terrain->frame().refraction, 0.13);
  }
}

}  // namespace
}  // namespace terrview

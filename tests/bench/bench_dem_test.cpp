// One test per promise in bench/bench_dem.h and bench/bench_view.h.
#include "bench/bench_dem.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "bench/bench_view.h"
#include "bench/scalar_rays.h"

namespace terrview {
namespace {

const float kNone = std::numeric_limits<float>::quiet_NaN();

bool is_exact_in_float(double value) {
  return static_cast<double>(static_cast<float>(value)) == value;
}

// Steps of no round number, turned a little, as a projected DEM has them.
BenchDem turned_dem() {
  HeightGrid grid{301, 257, std::vector<float>(301 * 257, 12.5F)};
  return make_bench_dem("turned", std::move(grid), {61.937, 0.713, 0.717, -92.641});
}

TEST(BenchDem, PostsAreExactInAFloat) {
  const BenchDem dem = turned_dem();
  for (int row = 0; row < dem.grid->rows; ++row)
    for (int column = 0; column < dem.grid->columns; ++column) {
      const glm::dvec2 xy_m = dem.scene_xy_m({column, row});
      ASSERT_TRUE(is_exact_in_float(xy_m.x) && is_exact_in_float(xy_m.y)) << column << ' ' << row;
    }
}

TEST(BenchDem, StepsAreRoundedByLessThanATwoHundredThousandthOfTheExtent) {
  const BenchDem dem = turned_dem();
  const double bound_m = dem.extent_m() / 200'000;
  EXPECT_NEAR(dem.step_m[0].x, 61.937, bound_m);
  EXPECT_NEAR(dem.step_m[0].y, 0.713, bound_m);
  EXPECT_NEAR(dem.step_m[1].x, 0.717, bound_m);
  EXPECT_NEAR(dem.step_m[1].y, -92.641, bound_m);
}

TEST(BenchDem, PostsWithoutDataGetTheMeanOfWhatLiesAround) {
  const BenchDem dem = make_bench_dem("voids", {2, 2, {7, kNone, 3, 5}}, {1, 0, 0, -1});
  EXPECT_EQ(dem.grid->heights_m, (std::vector<float>{7, 5, 3, 5}));
}

// A slope with a hole of 40 x 40 posts: no cliff stands at the hole's edge or in it.
TEST(BenchDem, NoCliffStandsWhereNothingIsKnown) {
  HeightGrid grid{100, 100, std::vector<float>(10'000)};
  for (int row = 0; row < 100; ++row)
    for (int column = 0; column < 100; ++column) {
      const bool hole = column >= 30 && column < 70 && row >= 20 && row < 60;
      grid.heights_m[static_cast<std::size_t>(row * 100 + column)] =
          hole ? kNone : static_cast<float>(10 * column);
    }
  cover_voids(grid);
  for (int row = 0; row < 100; ++row)
    for (int column = 1; column < 100; ++column)
      EXPECT_LE(std::abs(grid.at(column, row) - grid.at(column - 1, row)), 150)
          << column << ' ' << row;
}

TEST(SyntheticMountains, HaveTheirReliefAndSpacing) {
  const BenchDem dem = synthetic_mountains(65);
  EXPECT_EQ(dem.step_m, glm::dmat2(30, 0, 0, -30));
  const HeightRange range = height_range(*dem.grid);
  EXPECT_EQ(range.lowest_m, 0);
  EXPECT_NEAR(range.highest_m, 2000, 0.001);
}

TEST(SyntheticCity, IsFlatRoofsOnAPlain) {
  const BenchDem dem = synthetic_city(192);
  const std::set<float> heights_m(dem.grid->heights_m.begin(), dem.grid->heights_m.end());
  EXPECT_EQ(*heights_m.begin(), 0);
  EXPECT_GE(*std::next(heights_m.begin()), 6);
  EXPECT_LE(*heights_m.rbegin(), 90);
  EXPECT_GE(heights_m.size(), 4U);
  EXPECT_LE(heights_m.size(), 17U);  // 16 blocks and the plain
}

TEST(ReadBenchDem, LaysGeographicPostsAsTheyLieOnTheGround) {
  const BenchDem dem = read_bench_dem(TERRVIEW_SOURCE_DIR "/samples/vosges_like.tif");
  EXPECT_EQ(dem.name, "vosges_like");
  EXPECT_NEAR(dem.step_m[0].x, 60.0, 0.1);  // 0.000805 degrees of longitude at 48 N
  EXPECT_NEAR(dem.step_m[1].y, -90.1, 0.1);
  EXPECT_NEAR(dem.step_m[0].y, 0, 0.01);
}

TEST(SixViews, StandAboveTheGroundWhereAFloatCanSay) {
  for (const BenchDem& dem : {synthetic_mountains(65), synthetic_city(96), turned_dem()})
    for (const BenchView& view : six_views(dem, {8, 8})) {
      SCOPED_TRACE(dem.name + ", " + view.name);
      EXPECT_GT(view.eye_m.z, dem.height_m(view.eye_uv));
      for (int axis = 0; axis < 3; ++axis) EXPECT_TRUE(is_exact_in_float(view.eye_m[axis]));
      EXPECT_EQ(glm::dvec2(view.eye_m), dem.scene_xy_m(view.eye_uv));
    }
}

TEST(SixViews, TheGridlineViewLooksAlongAColumnFromItsPost) {
  const BenchView view = six_views(synthetic_mountains(65), {8, 8})[1];
  ASSERT_EQ(view.name, "gridline");
  EXPECT_EQ(view.eye_uv, glm::floor(view.eye_uv));
  EXPECT_EQ(view.camera.forward(), glm::dvec3(0, 1, 0));
}

BenchDem with_heights_times(float factor, const BenchDem& dem) {
  HeightGrid grid = *dem.grid;
  for (float& height_m : grid.heights_m) height_m *= factor;
  return make_bench_dem(dem.name, std::move(grid), dem.step_m);
}

double share_of_ground(const BenchDem& dem, const BenchView& view) {
  CameraOptions options = view.camera.options();
  options.size_px = {80, 64};
  TracedFrame frame(options.size_px);
  const Terrain terrain = terrain_of(dem, view, SurfaceModel::triangles, Search::pyramid);
  trace_rays(terrain, Camera(options), 1, frame);
  double hits = 0;
  for (const std::int32_t cell : frame.cell) hits += cell != kNoCell ? 1 : 0;
  return hits / static_cast<double>(frame.pixels());
}

TEST(ThesisViews, ShowAsMuchGroundAsThePhotos) {
  const BenchDem doubled = with_heights_times(2, thesis_mountains());
  EXPECT_NEAR(share_of_ground(doubled, thesis_valley(doubled)), 0.54, 0.02);
  const BenchDem tripled = with_heights_times(3, thesis_mountains());
  EXPECT_NEAR(share_of_ground(tripled, thesis_top(tripled)), 0.54, 0.02);
}

TEST(ShadowRays, LeaveFromAMillimetreAboveTheGroundThatIsSeen) {
  const BenchDem dem = synthetic_mountains(65);
  const BenchView view = six_views(dem, {24, 16})[3];
  const Terrain terrain = terrain_of(dem, view, SurfaceModel::hyperboloid, Search::plain);
  TracedFrame frame(view.camera.options().size_px);
  trace_rays(terrain, view.camera, 1, frame);
  const ShadowRays rays = shadow_rays(terrain, view, frame);
  std::int64_t count = 0;
  for (std::size_t i = 0; i < frame.pixels(); ++i) {
    ASSERT_EQ(std::isnan(rays.x_m[i]), frame.cell[i] == kNoCell);
    if (frame.cell[i] == kNoCell) continue;
    ++count;
    const glm::dvec2 xy_m(rays.x_m[i], rays.y_m[i]);
    const auto ground = terrain.ground_at(xy_m - glm::dvec2(view.eye_m));
    ASSERT_TRUE(ground);
    EXPECT_GE(rays.z_m[i] - ground->scene_height_m, 0.001);
    EXPECT_LE(rays.z_m[i] - ground->scene_height_m, 0.0015);
  }
  EXPECT_GT(count, 0);
  EXPECT_EQ(rays.count, count);
}

}  // namespace
}  // namespace terrview

// One test per promise in bench/surface_study.h.
#include "bench/surface_study.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace terrview {
namespace {

BenchDem saddle() { return make_bench_dem("saddle", {2, 2, {100, 0, 0, 100}}, {60, 0, 0, -60}); }

// Along the middle row the chord joins 50 m to 50 m; along a diagonal 100 to 100 or 0 to 0.
TEST(HeightSeen, DependsOnTheRaysPlaneForTheHyperboloidAlone) {
  const glm::dvec2 middle(0.5, 0.5);
  EXPECT_NEAR(height_seen_m(saddle(), SurfaceModel::hyperboloid, {-1, 0.5}, middle), 50, 1e-9);
  EXPECT_NEAR(height_seen_m(saddle(), SurfaceModel::hyperboloid, {-1, -1}, middle), 100, 1e-9);
  EXPECT_NEAR(height_seen_m(saddle(), SurfaceModel::hyperboloid, {-1, 2}, middle), 0, 1e-9);
  for (const glm::dvec2 eye : {glm::dvec2(-1, 0.5), glm::dvec2(-1, -1), glm::dvec2(-1, 2)}) {
    EXPECT_NEAR(height_seen_m(saddle(), SurfaceModel::triangles, eye, middle), 100, 1e-9);
    EXPECT_NEAR(height_seen_m(saddle(), SurfaceModel::bilinear, eye, middle), 50, 1e-9);
  }
}

TEST(GroundMotion, IsThatOfTheModelsThatDependOnTheRaysPlane) {
  const BenchDem dem = synthetic_mountains(129);
  const BenchView view = walkers_view(dem, {64, 36});
  for (const SurfaceModel model : {SurfaceModel::triangles, SurfaceModel::bilinear}) {
    const Motion still = ground_motion(dem, view, model);
    EXPECT_LT(still.height_m.most, 1e-9);
    EXPECT_LT(still.sweep_px, 1e-5);
  }
  for (const SurfaceModel model : {SurfaceModel::hyperboloid, SurfaceModel::band}) {
    const Motion moving = ground_motion(dem, view, model);
    EXPECT_GT(moving.height_m.most, 1e-4);
    EXPECT_GE(moving.sweep_px, moving.screen_px.p50);
  }
}

TEST(ErrorsAtDroppedPosts, AreThoseOfAParaboloidInClosedForm) {
  HeightGrid grid{65, 65, std::vector<float>(65 * 65)};
  for (int row = 0; row < 65; ++row)
    for (int column = 0; column < 65; ++column)
      grid.heights_m[static_cast<std::size_t>(row * 65 + column)] =
          static_cast<float>(column * column + row * row);
  const BenchDem dem = make_bench_dem("bowl", grid, {1, 0, 0, -1});
  // The mean of the four corners of a cell 2 wide is 2 m above the middle, any diagonal's, too.
  for (const SurfaceModel model : kSurfaceModels) {
    const HeightErrors errors = errors_at_dropped_posts(dem, model, DroppedPosts::in_cells);
    EXPECT_NEAR(errors.rms_m, 2, 1e-6);
    EXPECT_NEAR(errors.most_m, 2, 1e-6);
    // The mean of an edge's ends is 1 m above its middle. Of eight azimuths four go over it from
    // line to line of a band, aslant by the tangent of 22.5 degrees; not so at the rim.
    const HeightErrors edges = errors_at_dropped_posts(dem, model, DroppedPosts::on_edges);
    const double most_m = model == SurfaceModel::band ? 1 + 2 * std::tan(std::numbers::pi / 8) : 1;
    EXPECT_NEAR(edges.most_m, most_m, 1e-6);
    EXPECT_NEAR(edges.rms_m, std::sqrt((1 + most_m * most_m) / 2), most_m > 1 ? 0.02 : 1e-6);
  }
}

}  // namespace
}  // namespace terrview

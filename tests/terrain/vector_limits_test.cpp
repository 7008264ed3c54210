// One test per promise in terrain/vector_limits.h.
#include "terrain/vector_limits.h"

#include <gtest/gtest.h>

#include "tests/support/random_scene.h"
#include "tests/support/scenes.h"

namespace terrview {
namespace {

TEST(VectorLimits, AreOneHyperboloidLayer) {
  Random random(4);
  const auto one_of = [&](SurfaceModel model) {
    return random_terrain(random, model, Position::general);
  };
  for (int i = 0; i < 100; ++i) {
    EXPECT_TRUE(within_vector_limits(one_of(SurfaceModel::hyperboloid)));
    EXPECT_FALSE(within_vector_limits(one_of(SurfaceModel::triangles)));
    EXPECT_FALSE(within_vector_limits(random_layers(random, SurfaceModel::hyperboloid)));
  }
}

// 637 km are a tenth of the Earth's radius, along whichever axis it curves more. The reach is a
// post more than the farthest.
TEST(VectorLimits, EndAtAReachOf640KilometresOnARoundEarth) {
  constexpr double kCurvature_per_m = 1 / 6.37e6;
  const auto within = [](double reach_m, double north_per_m, double east_per_m) {
    const HeightGrid grid = make_grid(2, 2, [](int, int) { return 0; });
    return within_vector_limits(
        Terrain({make_layer(grid, {.spacing_m = {reach_m / 2, 1}})},
                {.north_curvature_per_m = north_per_m, .east_curvature_per_m = east_per_m},
                SurfaceModel::hyperboloid));
  };
  EXPECT_TRUE(within(630e3, kCurvature_per_m, kCurvature_per_m));
  EXPECT_FALSE(within(640e3, kCurvature_per_m, 0.9 * kCurvature_per_m));
  EXPECT_FALSE(within(640e3, 0.9 * kCurvature_per_m, kCurvature_per_m));
  EXPECT_TRUE(within(640e3, 0.9 * kCurvature_per_m, 0.9 * kCurvature_per_m));
  EXPECT_TRUE(within(6400e3, 0, 0));
}

}  // namespace
}  // namespace terrview

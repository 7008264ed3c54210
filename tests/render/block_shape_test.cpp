#include "render/block_shape.h"

#include <gtest/gtest.h>

#include "tests/support/scenes.h"

namespace terrview {
namespace {

TEST(BlockExaggeration, KeepsReliefWithinATwentiethOfTheSide) {
  EXPECT_EQ(block_exaggeration(1000, 20'000), 1);
  EXPECT_EQ(block_exaggeration(1000, 29'999), 1);
  EXPECT_EQ(block_exaggeration(1000, 30'000), 1.5);
  EXPECT_EQ(block_exaggeration(1300, 129'000), 4);
  EXPECT_EQ(block_exaggeration(1, 1e6), 20);
}

TEST(BlockExaggeration, LeavesSteepAndLevelGroundAlone) {
  EXPECT_EQ(block_exaggeration(3000, 10'000), 1);
  EXPECT_EQ(block_exaggeration(0, 10'000), 1);
}

TEST(BlockBounds, AreThoseOfGroundAndPlinth) {
  HeightGrid grid = make_grid(5, 4, [](int column, int) { return column == 2 ? 300.0 : 100.0; });
  grid.heights_m[4] = kVoid;  // the north-east post, which two other cells keep within the east
  const Terrain terrain = make_terrain(
      grid, {.eye_uv = {2, 1.5}, .spacing_m = {10, 20}, .eye_height_m = 1000, .z_scale = 2},
      SurfaceModel::hyperboloid);
  const ImageBounds front = block_bounds(terrain, -900, {1, 0, 0}, {0, 0, 1});
  EXPECT_EQ(front.low_m, glm::dvec2(-20, -900));
  EXPECT_EQ(front.high_m, glm::dvec2(20, 2 * 300 - 1000));
  const ImageBounds above = block_bounds(terrain, -900, {1, 0, 0}, {0, 1, 0});
  EXPECT_EQ(above.low_m, glm::dvec2(-20, -30));
  EXPECT_EQ(above.high_m, glm::dvec2(20, 30));
}

}  // namespace
}  // namespace terrview

// One test per promise of terrain/mean_heights.h.
#include "terrain/mean_heights.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include <glm/geometric.hpp>

#include "tests/support/scenes.h"

namespace terrview {
namespace {

TEST(MeanHeights, OfAPlaneAreThePlaneWithItsSlope) {
  const MeanHeights means(
      make_grid(64, 48, [](int column, int row) { return 100 + 0.5 * column - 0.25 * row; }));
  EXPECT_EQ(means.last_level(), 4);
  for (const double level : {1.0, 1.4, 2.0, 3.0}) {
    const glm::dvec2 uv(30.3, 21.8);
    const auto ground = means.at(level, uv);
    ASSERT_TRUE(ground);
    EXPECT_NEAR(ground->height_m, 100 + 0.5 * uv.x - 0.25 * uv.y, 1e-4) << level;
    EXPECT_NEAR(ground->slope_m.x, 0.5, 1e-5) << level;
    EXPECT_NEAR(ground->slope_m.y, -0.25, 1e-5) << level;
  }
}

TEST(MeanHeights, AreThoseOfTheBlocksPosts) {
  const HeightGrid grid = make_grid(
      32, 32, [](int column, int row) { return 50 * std::sin(column * 1.3 + row * row * 0.21); });
  const MeanHeights means(grid);
  for (int level = 1; level <= 3; ++level) {
    const int block = 1 << level;
    for (const glm::ivec2 at : {glm::ivec2(1, 2), glm::ivec2(2, 1)}) {
      double sum = 0;
      for (int row = at.y * block; row < (at.y + 1) * block; ++row)
        for (int column = at.x * block; column < (at.x + 1) * block; ++column)
          sum += grid.at(column, row);
      const glm::dvec2 middle = (glm::dvec2(at) + 0.5) * static_cast<double>(block) - 0.5;
      EXPECT_NEAR(means.at(level, middle)->height_m, sum / (block * block), 1e-4);
    }
  }
}

TEST(MeanHeights, AreTheSameInWhateverOrderRowsAreMade) {
  const HeightGrid grid =
      make_grid(37, 29, [](int column, int row) { return std::sin(column * 1.3 + row * 0.7); });
  const MeanHeights forwards(grid);
  const MeanHeights backwards(grid, [](int count, const std::function<void(int)>& work) {
    while (count > 0) work(--count);
  });
  for (double v = 0; v < 28; v += 0.9)
    for (double u = 0; u < 36; u += 0.9)
      EXPECT_EQ(forwards.at(1.5, {u, v})->height_m, backwards.at(1.5, {u, v})->height_m);
}

TEST(MeanHeights, ChangeContinuouslyWithLevelAndPlace) {
  const MeanHeights means(make_grid(65, 65, [](int column, int row) {
    return 50 * std::sin(column * 1.3) * std::cos(row * 0.7);
  }));
  for (double level = 1; level < 5; level += 0.25) {
    const double here = means.at(level, {20.2, 31.7})->height_m;
    EXPECT_NEAR(means.at(level + 1e-7, {20.2, 31.7})->height_m, here, 1e-4);
    EXPECT_NEAR(means.at(level, {20.2 + 1e-7, 31.7})->height_m, here, 1e-4);
  }
}

TEST(MeanHeights, LeaveOutPostsWithoutAHeight) {
  const MeanHeights means(make_grid(
      16, 16, [](int column, int) { return column == 6 ? static_cast<double>(kVoid) : 10.0; }));
  EXPECT_NEAR(means.at(2, {6, 6})->height_m, 10, 1e-5);
  const MeanHeights holed(make_grid(16, 16, [](int column, int row) {
    return column < 8 && row < 8 ? static_cast<double>(kVoid) : 10.0;
  }));
  EXPECT_FALSE(holed.at(2, {3, 3}));
  EXPECT_TRUE(holed.at(2, {14, 14}));
}

TEST(MeanHeights, OfASmallGridAreNone) {
  const MeanHeights means(make_grid(3, 3, [](int, int) { return 1.0; }));
  EXPECT_EQ(means.last_level(), 0);
  EXPECT_FALSE(means.at(1, {1, 1}));
}

TEST(NormalOfSlope, IsThatOfTheFacetOnAPlane) {
  const Place place{.eye_uv = {5, 5}, .spacing_m = {60, 90}, .eye_height_m = 900, .z_scale = 2};
  const Terrain terrain = make_terrain(
      make_grid(12, 12, [](int column, int row) { return 20.0 * column + 10.0 * row; }), place,
      SurfaceModel::triangles);
  const Hit hit = terrain.first_hit({{7, 7, 0}, {0, 0, -1}}).value();
  EXPECT_LT(glm::distance(normal_of_slope(terrain, hit, {20, 10}), terrain.facet_normal(hit)),
            1e-9);
  EXPECT_NEAR(post_distance_m(terrain.layers().front()), std::sqrt(60.0 * 90.0), 1e-9);
}

}  // namespace
}  // namespace terrview

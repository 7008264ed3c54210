#include "terrain/ground_map.h"

#include <gtest/gtest.h>

#include <limits>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "terrain/error.h"
#include "tests/support/random_scene.h"

namespace terrview {
namespace {

// 50 posts a kilometre eastward, 20 southward, turned so that u grows a little southward.
constexpr glm::dmat2 kJacobian{0.05, 0.001, -0.002, -0.02};

TEST(AffineGroundMap, PutsTheEyeAndItsSurroundingsOnTheGrid) {
  const AffineGroundMap map({10.5, 20.25}, kJacobian, {100, 100});
  EXPECT_EQ(map.to_grid({0, 0}), glm::dvec2(10.5, 20.25));
  EXPECT_NEAR(map.to_grid({100, 0}).x, 15.5, 1e-14);
  EXPECT_NEAR(map.to_grid({100, 0}).y, 20.35, 1e-14);
  EXPECT_NEAR(map.to_grid({0, 100}).x, 10.3, 1e-14);
  EXPECT_NEAR(map.to_grid({0, 100}).y, 18.25, 1e-14);
  EXPECT_EQ(map.jacobian({123, 456}), kJacobian);
}

TEST(AffineGroundMap, EveryLineIsOnePiece) {
  const AffineGroundMap map({10.5, 20.25}, kJacobian, {100, 100});
  EXPECT_EQ(map.piece_end_m({{3, 4}, {0.6, 0.8}}, 0, 1e6), 1e6);
  EXPECT_EQ(map.piece_end_m({{3, 4}, {0.6, 0.8}}, 17, 18), 18);
}

TEST(AffineGroundMap, NoPostLiesBeyondItsReach) {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const Terrain terrain = random_terrain(random, SurfaceModel::triangles, Position::special);
    const TerrainLayer& layer = terrain.layers().front();
    const glm::dmat2 to_ground = glm::inverse(layer.map->jacobian({0, 0}));
    for (int row = 0; row < layer.grid->rows; ++row) {
      for (int column = 0; column < layer.grid->columns; ++column) {
        const glm::dvec2 away = glm::dvec2(column, row) - layer.map->to_grid({0, 0});
        EXPECT_LT(glm::length(to_ground * away), layer.map->reach_m());
      }
    }
  }
}

TEST(AffineGroundMap, RefusesPostsOnALine) {
  EXPECT_THROW(AffineGroundMap({0, 0}, glm::dmat2(1, 2, 2, 4), {5, 5}), InputError);
  EXPECT_THROW(AffineGroundMap({0, 0}, glm::dmat2(0), {5, 5}), InputError);
  EXPECT_THROW(AffineGroundMap({0, 0}, glm::dmat2(std::numeric_limits<double>::infinity()), {5, 5}),
               InputError);
}

TEST(GroundLine, RunsInMetresAlongItsDirection) {
  const GroundLine line{{100, -50}, {0.6, 0.8}};
  EXPECT_EQ(line.at(0), glm::dvec2(100, -50));
  EXPECT_NEAR(line.at(10).x, 106, 1e-13);
  EXPECT_NEAR(line.at(10).y, -42, 1e-13);
}

}  // namespace
}  // namespace terrview

// The promises of terrain/terrain.h besides rounding: the ground at a point, normals, and rays that
// leave the ground.
#include "terrain/terrain.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include <glm/geometric.hpp>

#include "tests/support/expectations.h"
#include "tests/support/oracle.h"
#include "tests/support/random_scene.h"
#include "tests/support/scenes.h"

namespace terrview {
namespace {

class TerrainOf : public ModelTest {};

TEST_P(TerrainOf, GroundAtAPostIsItsHeightTimesTheZScale) {
  const Place place{.eye_uv = {2, 3}, .spacing_m = {60, 90}, .z_scale = 2};
  const Terrain hills =
      terrain(make_grid(6, 7, [](int c, int r) { return 10 * c * c - 7 * r; }), place);
  for (int row = 0; row < 7; ++row) {
    for (int column = 0; column < 6; ++column) {
      const auto ground = hills.ground_at(ground_of(place, {column, row}));
      ASSERT_TRUE(ground);
      EXPECT_NEAR(ground->scene_height_m, 2.0 * (10 * column * column - 7 * row), 1e-10);
      EXPECT_NEAR(ground->uv.x, column, 1e-14);
      EXPECT_NEAR(ground->uv.y, row, 1e-14);
    }
  }
}

TEST_P(TerrainOf, GroundAtAPointOfACellIsTheModels) {
  Random random(1);
  int grounds = 0;
  for (int i = 0; i < 3000; ++i) {
    const Terrain here = random_terrain(random, GetParam(), Position::general);
    const auto ground =
        here.ground_at(glm::dvec2(random_ray(random, here, Position::general).origin_m));
    if (!ground) continue;
    const TerrainLayer& layer = here.layers().front();
    const auto expected_m = oracle::scene_height_m(
        *layer.grid, GetParam(), ground->cell, ground->uv.x, ground->uv.y, here.frame().z_scale);
    EXPECT_NEAR(ground->scene_height_m, static_cast<double>(expected_m), 1e-8);
    ++grounds;
  }
  EXPECT_GT(grounds, 1000);
}

TEST_P(TerrainOf, GroundAtTheEdgeOfAHoleIsThatOfTheCellBeside) {
  const Place place{};
  const Terrain slope = terrain(
      make_grid(7, 7, [](int c, int r) { return c == 3 && r == 3 ? kVoid : 10.0 * c + r; }), place);
  for (const glm::dvec2 edge : {glm::dvec2(2, 2.5), {2.5, 2}, {2, 2}, {4, 2.5}, {2.5, 4}, {4, 4}}) {
    const auto ground = slope.ground_at(ground_of(place, edge));
    ASSERT_TRUE(ground) << edge.x << ' ' << edge.y;
    EXPECT_NEAR(ground->scene_height_m, 10 * edge.x + edge.y, 1e-13);
    EXPECT_TRUE(slope.layers()[0].grid->has_ground(ground->cell.x, ground->cell.y));
  }
  for (const glm::dvec2 inside : {glm::dvec2(2.01, 2.5), {2.5, 3}, {3, 3}, {3.99, 3.99}})
    EXPECT_FALSE(slope.ground_at(ground_of(place, inside)));
}

TEST_P(TerrainOf, TheFirstLayerThatHasGroundWins) {
  const HeightGrid fine =
      make_grid(5, 5, [](int c, int r) { return c == 0 && r == 0 ? kVoid : 20; });
  const HeightGrid coarse = make_grid(5, 5, [](int, int) { return 10; });
  const Terrain both({make_layer(fine, {.eye_uv = {2, 2}}),
                      make_layer(coarse, {.eye_uv = {2, 2}, .spacing_m = {4, 4}})},
                     {.eye_height_m = 50}, GetParam());
  EXPECT_EQ(both.ground_at({0, 0})->grid, 0);
  EXPECT_EQ(both.ground_at({0, 0})->scene_height_m, 20);
  EXPECT_EQ(both.ground_at({5, 0})->grid, 1);
  EXPECT_EQ(both.ground_at({5, 0})->scene_height_m, 10);
  EXPECT_EQ(both.ground_at({-1.5, 1.5})->grid, 1);  // the hole of the fine grid
  EXPECT_FALSE(both.ground_at({8.5, 0}));
  expect_hit_at(both, {.direction = {0, 0, -1}}, 30, 1e-13);
  expect_hit_at(both, {{-1.5, 1.5, 0}, {0, 0, -1}}, 40, 1e-13);
}

// A plateau 10 m above the plain, in a finer grid: its edge is a vertical face.
TEST_P(TerrainOf, AVerticalFaceClosesTheStepUpBetweenTwoGrids) {
  const HeightGrid plateau = make_grid(5, 5, [](int, int) { return 10; });
  const HeightGrid plain = make_grid(21, 21, [](int, int) { return 0; });
  const Terrain both(
      {make_layer(plateau, {.eye_uv = {-6.25, 2.25}}), make_layer(plain, {.eye_uv = {4.1, 10.1}})},
      {.eye_height_m = 4}, GetParam());
  const auto hit = judged_hit(both, {.direction = {1, 0, 0}});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->distance_m, 6.25, 1e-13);
  EXPECT_EQ(hit->grid, 0);
  expect_hit_at(both, ray_towards({0, 0, 0}, {6.25, 0, 5.9}), std::hypot(6.25, 5.9), 1e-13);
  expect_free(both, ray_towards({0, 0, 0}, {6.25, 0, 6.1}));
  expect_hit_at(both, ray_towards({0, 0, 0}, {6.2, 0, -4}), std::hypot(6.2, 4), 1e-13);
}

// Down from the plateau there is no face to meet, and the ray goes on to the plain.
TEST_P(TerrainOf, ARayPassesAStepDownBetweenTwoGrids) {
  const HeightGrid plateau = make_grid(5, 5, [](int, int) { return 10; });
  const HeightGrid plain = make_grid(41, 41, [](int, int) { return 0; });
  const Terrain both(
      {make_layer(plateau, {.eye_uv = {2.3, 2.2}}), make_layer(plain, {.eye_uv = {10.1, 10.1}})},
      {.eye_height_m = 12}, GetParam());
  expect_hit_at(both, ray_towards({0, 0, 0}, {1.6, 0, -2}), std::hypot(1.6, 2), 1e-13);
  expect_hit_at(both, ray_towards({0, 0, 0}, {1.8, 0, -2}), 6 * std::hypot(1.8, 2), 1e-13);
}

constexpr double kSlopeX = 0.25;
constexpr double kSlopeY = -0.5;

// Dyadic slopes and spacings: exact in float, so that any error is the tracer's.
HeightGrid plane_grid() {
  return make_grid(17, 17, [](int c, int r) { return 64 * c * kSlopeX - 32 * r * kSlopeY + 100; });
}

constexpr Place kPlanePlace{.eye_uv = {8.25, 8.75}, .spacing_m = {64, 32}, .eye_height_m = 700};

glm::dvec3 plane_normal() { return glm::normalize(glm::dvec3(-kSlopeX, -kSlopeY, 1)); }

TEST_P(TerrainOf, NormalsOfAPlaneAreThePlanes) {
  const Terrain plane = terrain(plane_grid(), kPlanePlace);
  int hits = 0;
  for (const Ray& ray : rays_all_round(60)) {
    for (const double rise : {-30.0, -3.0, -2.0}) {
      const auto hit = plane.first_hit({.direction = ray.direction + glm::dvec3(0, 0, rise)});
      if (!hit) continue;
      EXPECT_LT(glm::length(plane.facet_normal(*hit) - plane_normal()), 1e-15);
      EXPECT_LT(glm::length(plane.smooth_normal(*hit) - plane_normal()), 1e-15);
      ++hits;
    }
  }
  EXPECT_GT(hits, 100);
}

TEST_P(TerrainOf, NormalsTurnWithTheGridAndSteepenWithTheZScale) {
  const double angle = 0.3;
  const glm::dmat2 turn(std::cos(angle), std::sin(angle), -std::sin(angle), std::cos(angle));
  const auto grid = std::make_shared<const HeightGrid>(
      make_grid(9, 9, [](int c, int r) { return 3 * c + 5 * r; }));
  const auto map =
      std::make_shared<const AffineGroundMap>(glm::dvec2(4.2, 4.3), turn / 10.0, glm::ivec2(9, 9));
  const Terrain plane({{grid, map}}, {.eye_height_m = 500, .z_scale = 2}, GetParam());
  const auto hit = plane.first_hit({.direction = {0.01, 0.02, -1}});
  ASSERT_TRUE(hit);
  // dh/dx = 3 du/dx + 5 dv/dx, and so for y.
  const double across = 2 * (3 * std::cos(angle) + 5 * std::sin(angle)) / 10;
  const double along = 2 * (-3 * std::sin(angle) + 5 * std::cos(angle)) / 10;
  const glm::dvec3 expected = glm::normalize(glm::dvec3(-across, -along, 1));
  EXPECT_LT(glm::length(plane.facet_normal(*hit) - expected), 1e-15);
  EXPECT_LT(glm::length(plane.smooth_normal(*hit) - expected), 1e-15);
}

Hit hit_at(glm::dvec2 uv) {
  return {0, {0, 0, 0}, 0, {static_cast<int>(uv.x), static_cast<int>(uv.y)}, uv};
}

// A ridge: central differences on its crest, one-sided ones at the border and beside a void.
TEST_P(TerrainOf, SmoothNormalsAreCentralDifferencesAtThePosts) {
  const HeightGrid ridge = make_grid(7, 7, [](int c, int r) {
    return c == 5 && r == 1 ? double{kVoid} : 4.0 * std::abs(c - 3) + r * r;
  });
  const Terrain here = terrain(ridge, {.eye_uv = {3, 3}, .eye_height_m = 90});
  const auto slopes_at = [&](glm::dvec2 uv) {
    const glm::dvec3 normal = here.smooth_normal(hit_at(uv));
    return glm::dvec2(-normal.x / normal.z, normal.y / normal.z);  // dh/du, dh/dv
  };
  EXPECT_LT(glm::length(slopes_at({3, 3}) - glm::dvec2(0, 6)), 1e-14);
  EXPECT_LT(glm::length(slopes_at({2, 3}) - glm::dvec2(-4, 6)), 1e-14);
  EXPECT_LT(glm::length(slopes_at({2.5, 3}) - glm::dvec2(-2, 6)), 1e-14);
  EXPECT_LT(glm::length(slopes_at({0, 0}) - glm::dvec2(-4, 1)), 1e-14);
  EXPECT_LT(glm::length(slopes_at({1, 3.5}) - glm::dvec2(-4, 7)), 1e-14);
  EXPECT_LT(glm::length(slopes_at({5, 2}) - glm::dvec2(4, 5)), 1e-14);
}

// Away from borders and holes, as beside them.
TEST_P(TerrainOf, SmoothNormalsFollowThePostsSlopesThroughCells) {
  const HeightGrid rough =
      make_grid(9, 8, [](int c, int r) { return 20 * std::sin(1.7 * c + 0.9 * r * c); });
  const Terrain here = terrain(rough, {.eye_uv = {3, 3}, .eye_height_m = 90});
  const auto slope_at = [&](int c, int r) {
    return glm::dvec2(rough.at(c + 1, r) - rough.at(c - 1, r),
                      rough.at(c, r + 1) - rough.at(c, r - 1)) /
           2.0;
  };
  for (int r = 1; r < 6; ++r) {
    for (int c = 1; c < 7; ++c) {
      const glm::dvec2 f(0.3, 0.6);
      const glm::dvec2 expected =
          (1 - f.y) * ((1 - f.x) * slope_at(c, r) + f.x * slope_at(c + 1, r)) +
          f.y * ((1 - f.x) * slope_at(c, r + 1) + f.x * slope_at(c + 1, r + 1));
      const glm::dvec3 normal = here.smooth_normal(hit_at(glm::dvec2(c, r) + f));
      EXPECT_LT(glm::length(glm::dvec2(-normal.x, normal.y) / normal.z - expected), 1e-5);
    }
  }
}

TEST_P(TerrainOf, FacetNormalsAreThoseOfTheSurfaceInTheCell) {
  const Terrain here =
      terrain(make_grid(2, 2, [](int c, int r) { return c == 1 && r == 0 ? 2 : 0; }),
              {.eye_uv = {0.5, 0.5}, .eye_height_m = 90});
  const auto slopes_at = [&](glm::dvec2 uv) {
    const glm::dvec3 normal = here.facet_normal(hit_at(uv));
    return glm::dvec2(-normal.x / normal.z, normal.y / normal.z);  // dh/du, dh/dv
  };
  const bool triangles = GetParam() == SurfaceModel::triangles;
  const glm::dvec2 north_east = triangles ? glm::dvec2(2, -2) : glm::dvec2(1.5, -1.5);
  const glm::dvec2 south_west = triangles ? glm::dvec2(0, 0) : glm::dvec2(0.5, -0.5);
  EXPECT_LT(glm::length(slopes_at({0.75, 0.25}) - north_east), 1e-15);
  EXPECT_LT(glm::length(slopes_at({0.25, 0.75}) - south_west), 1e-15);
}

INSTANTIATE_TEST_SUITE_P(Models, TerrainOf, testing::ValuesIn(kSurfaceModels), model_name);

}  // namespace
}  // namespace terrview

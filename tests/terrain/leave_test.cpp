// Rays that leave the ground do not meet the ground they leave.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

#include "terrain/terrain.h"
#include "tests/support/expectations.h"
#include "tests/support/random_scene.h"
#include "tests/support/scenes.h"

namespace terrview {
namespace {

class Leave : public ModelTest {};

// Upward directions all round, from the zenith down to the plane itself.
template <class Expect>
void for_directions_above(double slope_x, double slope_y, const Expect& expect) {
  for (const Ray& level : rays_all_round(24)) {
    const double along = slope_x * level.direction.x + slope_y * level.direction.y;
    for (const double rise : {0.0, 1e-12, 1e-7, 1e-3, 0.1, 1.0, 10.0})
      expect(glm::normalize(level.direction + glm::dvec3(0, 0, along + rise)));
  }
  expect(glm::dvec3(0, 0, 1));
}

TEST_P(Leave, ARayFromFlatGroundNeverMeetsIt) {
  for (const double height_m : {0.0, 100.0, 8848.0}) {
    const Terrain plain =
        terrain(make_grid(30, 30, [&](int, int) { return height_m; }),
                {.eye_uv = {14.5, 15}, .spacing_m = {60, 90}, .eye_height_m = height_m + 50});
    for (const Ray& ray : rays_all_round(30)) {
      const auto hit = plain.first_hit({.direction = ray.direction + glm::dvec3(0, 0, -0.1)});
      ASSERT_TRUE(hit);
      for_directions_above(0, 0, [&](const glm::dvec3& direction) {
        EXPECT_FALSE(plain.occluded(plain.leave(*hit, direction)));
      });
    }
  }
}

TEST_P(Leave, ARayFromASlopeNeverMeetsIt) {
  const Place place{.eye_uv = {8.25, 8.75}, .spacing_m = {64, 32}, .eye_height_m = 700};
  const Terrain slope =
      terrain(make_grid(17, 17, [](int c, int r) { return 16 * c + 16 * r + 100; }), place);
  for (const Ray& ray : rays_all_round(30)) {
    const auto hit = slope.first_hit({.direction = ray.direction + glm::dvec3(0, 0, -3)});
    ASSERT_TRUE(hit);
    for_directions_above(16 / 64.0, -16 / 32.0, [&](const glm::dvec3& direction) {
      EXPECT_FALSE(slope.occluded(slope.leave(*hit, direction)));
    });
  }
}

// On a round Earth level ground falls away from any level ray.
TEST_P(Leave, ARayFromALevelPlainOfARoundEarthNeverMeetsIt) {
  const TerrainLayer layer = make_layer(make_grid(50, 50, [](int, int) { return 200; }),
                                        {.eye_uv = {24.5, 25}, .spacing_m = {900, 900}});
  const VerticalFrame frame{.eye_height_m = 300,
                            .north_curvature_per_m = 1 / 6.36e6,
                            .east_curvature_per_m = 1 / 6.38e6,
                            .refraction = 0.13};
  const Terrain plain({layer}, frame, GetParam());
  for (const Ray& ray : rays_all_round(30)) {
    const auto hit = plain.first_hit({.direction = ray.direction + glm::dvec3(0, 0, -0.02)});
    ASSERT_TRUE(hit);
    const glm::dvec2 away = glm::normalize(glm::dvec2(hit->position_m));
    const double dip = -(1 - 0.13) * glm::length(glm::dvec2(hit->position_m)) / 6.36e6;
    for_directions_above(dip * away.x, dip * away.y, [&](const glm::dvec3& direction) {
      EXPECT_FALSE(plain.occluded(plain.leave(*hit, direction)));
    });
  }
}

// Over rough ground only other ground may stop it.
TEST_P(Leave, ARayFromRoughGroundIsStoppedOnlyWhereTheOracleSeesGround) {
  Random random(1);
  int shadows = 0;
  int lit = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Terrain rough = random_terrain(random, GetParam(), Position::general);
    const auto hit = rough.first_hit(random_ray(random, rough, Position::general));
    if (!hit) continue;
    const glm::dvec3 sun(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.01, 1));
    const Ray shadow = rough.leave(*hit, sun);
    EXPECT_FALSE(rough.occluded(rough.leave(*hit, {0, 0, 1})));
    const auto judgement = oracle::judge(rough, shadow);
    ASSERT_NE(judgement.verdict, oracle::Verdict::wrong)
        << i << " " << oracle::to_string(shadow) << ": " << judgement.fault;
    (rough.occluded(shadow) ? shadows : lit) += 1;
  }
  EXPECT_GT(shadows, 1000);
  EXPECT_GT(lit, 1000);
}

INSTANTIATE_TEST_SUITE_P(Models, Leave, testing::ValuesIn(kSurfaceModels), model_name);

}  // namespace
}  // namespace terrview

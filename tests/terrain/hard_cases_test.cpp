// Rays and eyes that break tracers, each by name, under every surface model; hard_grids_test.cpp
// has the grids. The answers are known in closed form, and the oracle judges them, too.
#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "terrain/terrain.h"
#include "tests/support/expectations.h"
#include "tests/support/scenes.h"

namespace terrview {
namespace {

class HardCase : public ModelTest {};

double ridge_in_row_5(int /*column*/, int row) { return row == 5 ? 10 : 0; }

// The slope of a one-row ridge 10 m high, seen from 5 m above its foot 5 rows away, is met half way
// up: at 4.5 rows.
TEST_P(HardCase, RaysAlongColumnsMeetARidgeWhereItsFlankIsAtEyeHeight) {
  for (const double column : {0.0, 3.0, 8.0}) {
    const Terrain ridge =
        terrain(make_grid(9, 11, ridge_in_row_5), {.eye_uv = {column, 0}, .eye_height_m = 5});
    expect_hit_at(ridge, {.direction = {0, -1, 0}}, 4.5, 1e-12);
    const Terrain from_south =
        terrain(make_grid(9, 11, ridge_in_row_5), {.eye_uv = {column, 10}, .eye_height_m = 5});
    expect_hit_at(from_south, {.direction = {0, 1, 0}}, 4.5, 1e-12);
  }
}

TEST_P(HardCase, RaysAlongRowsMeetARidgeWhereItsFlankIsAtEyeHeight) {
  const auto ridge_in_column_5 = [](int column, int row) { return ridge_in_row_5(row, column); };
  for (const double row : {0.0, 3.0, 8.0}) {
    const Terrain ridge =
        terrain(make_grid(11, 9, ridge_in_column_5), {.eye_uv = {0, row}, .eye_height_m = 5});
    expect_hit_at(ridge, {.direction = {1, 0, 0}}, 4.5, 1e-12);
    const Terrain from_east =
        terrain(make_grid(11, 9, ridge_in_column_5), {.eye_uv = {10, row}, .eye_height_m = 5});
    expect_hit_at(from_east, {.direction = {-1, 0, 0}}, 4.5, 1e-12);
  }
}

TEST_P(HardCase, RaysAlongDiagonalsMeetFlatGroundInAStraightLine) {
  const Terrain flat =
      terrain(make_grid(9, 9, [](int, int) { return 0; }), {.eye_uv = {4, 4}, .eye_height_m = 3});
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0})
      expect_hit_at(flat, ray_towards({0, 0, 0}, {3 * x, 3 * y, -3}), std::sqrt(27.0), 1e-14 * 27);
}

TEST_P(HardCase, ARayAimedAtASummitPostHitsItAndOneJustAboveDoesNot) {
  const Place place{.eye_uv = {0.3, 7.1}, .spacing_m = {60, 90}, .eye_height_m = 100};
  const Terrain peak =
      terrain(make_grid(9, 9, [](int c, int r) { return c == 5 && r == 3 ? 700 : 0; }), place);
  const glm::dvec3 summit(ground_of(place, {5, 3}), 600);
  const double distance_m = glm::length(summit);
  expect_hit_at(peak, ray_towards({0, 0, 0}, summit - glm::dvec3(0, 0, 1e-6)), distance_m, 1e-5);
  expect_free(peak, ray_towards({0, 0, 0}, summit + glm::dvec3(0, 0, 1e-6)));
  judged_hit(peak, ray_towards({0, 0, 0}, summit));
}

TEST_P(HardCase, VerticalRaysMeetTheGroundBelowAndNeverFromBelow) {
  const Terrain slope = terrain(make_grid(5, 5, [](int c, int r) { return 2 * c + r; }),
                                {.eye_uv = {2, 2}, .eye_height_m = 50});
  for (const glm::dvec2 uv : {glm::dvec2(2, 2), glm::dvec2(1.25, 3), glm::dvec2(0, 0),
                              glm::dvec2(4, 4), glm::dvec2(3.5, 0.5)}) {
    const glm::dvec2 ground = uv - glm::dvec2(2, 2);
    const double height_m = 2 * uv.x + uv.y;
    const glm::dvec3 above(ground.x, -ground.y, 0);
    expect_hit_at(slope, {above, {0, 0, -1}}, 50 - height_m, 1e-13);
    expect_free(slope, {above, {0, 0, 1}});
    expect_free(slope, {above, {0, 0, -1}, 50 - height_m - 0.001});
    const glm::dvec3 below(ground.x, -ground.y, -60);
    expect_ends_below(slope, {below, {0, 0, 1}});
    expect_ends_below(slope, {below, {0, 0, -1}});
  }
  expect_free(slope, {{2.01, 0, 0}, {0, 0, -1}});
}

TEST_P(HardCase, AlmostVerticalRaysMeetTheGroundBelow) {
  const Terrain slope = terrain(make_grid(5, 5, [](int c, int r) { return 2 * c + r; }),
                                {.eye_uv = {1.3, 2.6}, .eye_height_m = 50});
  for (const double sideways : {1e-300, 1e-17, 1e-15, 1e-12, 1e-9, 1e-6}) {
    const Ray ray{{0, 0, 0}, glm::normalize(glm::dvec3(sideways, -sideways, -1))};
    expect_hit_at(slope, ray, 50 - 2 * 1.3 - 2.6, 200 * sideways + 1e-12);
  }
}

TEST_P(HardCase, LevelRaysOverAPlainAreFreeAMillimetreAboveItAndEndAMillimetreBelow) {
  const HeightGrid plain = make_grid(20, 20, [](int, int) { return 700; });
  for (const Ray& ray : rays_all_round(24)) {
    expect_free(terrain(plain, {.eye_uv = {9, 9}, .eye_height_m = 700.001}), ray);
    expect_ends_below(terrain(plain, {.eye_uv = {9, 9}, .eye_height_m = 699.999}), ray);
  }
}

TEST_P(HardCase, FlatGroundIsMetAtAGrazingAngleOfATenMillionth) {
  const Terrain plain =
      terrain(make_grid(100, 3, [](int, int) { return 0; }),
              {.eye_uv = {0.5, 1}, .spacing_m = {200, 200}, .eye_height_m = 1e-3});
  const Ray ray{.direction = glm::normalize(glm::dvec3(std::cos(1e-7), 0, -std::sin(1e-7)))};
  expect_hit_at(plain, ray, 1e-3 / std::sin(1e-7), 1e-6);
  expect_free(plain, {.direction = glm::normalize(glm::dvec3(1, 0, 1e-7))});
}

TEST_P(HardCase, AnEyeOnAPostOrAnEdgeSeesUpwardAndNotIntoTheGround) {
  for (const glm::dvec2 eye_uv : {glm::dvec2(4, 4), glm::dvec2(4, 4.5), glm::dvec2(4.5, 4)}) {
    const Terrain plain = terrain(make_grid(9, 9, [](int, int) { return 250; }),
                                  {.eye_uv = eye_uv, .eye_height_m = 250});
    expect_free(plain, ray_towards({0, 0, 0}, {1, 2, 1e-9}));
    expect_free(plain, ray_towards({0, 0, 0}, {-1, 0, 1}));
    expect_hit_at(plain, ray_towards({0, 0, 0}, {1, 2, -1e-9}), 0, 0);
    expect_hit_at(plain, ray_towards({0, 0, 0}, {-1, 0, -1}), 0, 0);
  }
}

TEST_P(HardCase, AnEyeOnAPostOfASaddleSeesOverOneDiagonalAndNotTheOther) {
  const HeightGrid saddle = make_grid(2, 2, [](int c, int r) { return c == r ? 100 : 0; });
  const Terrain on_summit = terrain(saddle, {.eye_uv = {0, 0}, .eye_height_m = 100});
  judged_hit(on_summit, ray_towards({0, 0, 0}, {1, -1, 1}));
  judged_hit(on_summit, ray_towards({0, 0, 0}, {1, -0.7, 0}));
  const Terrain in_valley = terrain(saddle, {.eye_uv = {1, 0}, .eye_height_m = 0});
  judged_hit(in_valley, ray_towards({0, 0, 0}, {-1, -1, 1}));
  judged_hit(in_valley, ray_towards({0, 0, 0}, {-0.9, -1, 60}));
}

TEST_P(HardCase, AnEyeAMillimetreAboveARoughGroundAgreesWithTheOracle) {
  const auto rough = [](int c, int r) { return 300 + 40 * std::sin(1.7 * c + 0.4 * r * r); };
  for (const glm::dvec2 eye_uv : {glm::dvec2(4, 4), glm::dvec2(4, 4.25)}) {
    const HeightGrid grid = make_grid(12, 12, rough);
    const Place place{.eye_uv = eye_uv, .spacing_m = {25, 25}};
    const double ground_m = terrain(grid, place).ground_at({0, 0})->scene_height_m;
    const Terrain near_ground =
        terrain(grid, {.eye_uv = eye_uv, .spacing_m = {25, 25}, .eye_height_m = ground_m + 1e-3});
    for (const Ray& ray : rays_all_round(72)) {
      for (const double rise : {-1.0, -0.1, -1e-4, 0.0, 1e-4, 0.1, 1.0})
        judged_hit(near_ground, ray_towards({0, 0, 0}, ray.direction + glm::dvec3(0, 0, rise)));
    }
  }
}

TEST_P(HardCase, AnEye400KilometresUpMeetsAPlaneToAMicrometre) {
  const Terrain plane = terrain(make_grid(40, 40, [](int c, int r) { return 8 * c + 4 * r; }),
                                {.eye_uv = {20, 20}, .spacing_m = {64, 64}, .eye_height_m = 4e5});
  expect_hit_at(plane, {.direction = {0, 0, -1}}, 4e5 - 240, 1e-6);
  for (const glm::dvec2 uv : {glm::dvec2(0.5, 38.5), glm::dvec2(31, 2), glm::dvec2(20, 7.3)}) {
    const glm::dvec3 target(64 * (uv.x - 20), 64 * (20 - uv.y), 8 * uv.x + 4 * uv.y - 4e5);
    expect_hit_at(plane, ray_towards({0, 0, 0}, target), glm::length(target), 1e-6);
  }
}

INSTANTIATE_TEST_SUITE_P(Models, HardCase, testing::ValuesIn(kSurfaceModels), model_name);

}  // namespace
}  // namespace terrview

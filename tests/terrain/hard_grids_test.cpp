// Grids and places that break tracers, each by name, under every surface model; hard_cases_test.cpp
// has the rays. The answers are known in closed form, and the oracle judges them, too.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "terrain/error.h"
#include "terrain/terrain.h"
#include "tests/support/expectations.h"
#include "tests/support/scenes.h"

namespace terrview {
namespace {

class HardGrid : public ModelTest {};

TEST_P(HardGrid, AnEyeUnderTheGroundSeesNothingEvenWhereTheRayComesOutOfIt) {
  const Terrain hill = terrain(make_grid(9, 9, [](int, int r) { return r == 4 ? 100 : 0; }),
                               {.eye_uv = {4, 4}, .eye_height_m = 50});
  expect_ends_below(hill, ray_towards({0, 0, 0}, {0, -1, 0}));
  expect_ends_below(hill, ray_towards({0, 0, 0}, {0, -1, -20}));
  expect_ends_below(hill, ray_towards({0, 0, 0}, {0, 0, 1}));
}

TEST_P(HardGrid, AnEyeOutsideTheGridSeesItsTopAndNeverAWallUnderItsEdge) {
  const HeightGrid table = make_grid(5, 5, [](int, int) { return 100; });
  const Place place{.eye_uv = {-3, 2.2}, .eye_height_m = 101};
  expect_hit_at(terrain(table, place), ray_towards({0, 0, 0}, {4, 0, -1}), std::sqrt(17.0), 1e-13);
  expect_free(terrain(table, place), ray_towards({0, 0, 0}, {8, 0, -1}));
  expect_free(terrain(table, place), ray_towards({0, 0, 0}, {-4, 0, -1}));
  const Place low{.eye_uv = {-3, 2.2}, .eye_height_m = 99};
  expect_ends_below(terrain(table, low), ray_towards({0, 0, 0}, {4, 0, 0}));
  expect_ends_below(terrain(table, low), ray_towards({0, 0, 0}, {4, 0, 0.5}));
}

TEST_P(HardGrid, OneCellIsAWholeTerrain) {
  const Terrain cell = terrain(make_grid(2, 2, [](int c, int r) { return 3 * c - 2 * r; }),
                               {.eye_uv = {0.5, 0.5}, .eye_height_m = 10.5});
  expect_hit_at(cell, {.direction = {0, 0, -1}}, 10, 1e-14);
  for (const Ray& ray : rays_all_round(36)) {
    const glm::dvec2 p = 0.4 * glm::dvec2(ray.direction);
    const glm::dvec3 on_ground(p, 3 * p.x + 2 * p.y - 10);
    expect_hit_at(cell, ray_towards({0, 0, 0}, on_ground), glm::length(on_ground), 1e-13);
    expect_free(cell, ray);
  }
}

TEST_P(HardGrid, CellsThatTouchAVoidPostAreHoles) {
  const HeightGrid grid =
      make_grid(7, 7, [](int c, int r) { return c == 3 && r == 3 ? kVoid : 20; });
  const Terrain plain = terrain(grid, {.eye_uv = {3.5, 6}, .eye_height_m = 23});
  const auto down_to = [](double v) { return ray_towards({0, 0, 0}, {0, 6 - v, -3}); };
  expect_hit_at(plain, down_to(4.01), std::hypot(1.99, 3), 1e-13);
  expect_hit_at(plain, down_to(1.99), std::hypot(4.01, 3), 1e-13);
  for (const double v : {3.99, 3.5, 3.0, 2.5, 2.01}) expect_ends_below(plain, down_to(v));
  EXPECT_FALSE(plain.ground_at({0, 3.0}));
}

TEST_P(HardGrid, ARayOverAVoidMeetsWhatIsBehind) {
  const HeightGrid grid =
      make_grid(9, 3, [](int c, int) { return c >= 3 && c <= 5 ? kVoid : (c == 8 ? 50 : 0); });
  const Terrain valley = terrain(grid, {.eye_uv = {0, 1}, .eye_height_m = 25});
  expect_hit_at(valley, {.direction = {1, 0, 0}}, 7.5, 1e-13);
  expect_free(valley, {.direction = {1, 0, 0}, .length_m = 7.4});
  expect_ends_below(valley, ray_towards({0, 0, 0}, {4, 0, -25}));
}

TEST_P(HardGrid, ABorderOfVoidsIsNoGround) {
  const HeightGrid grid = make_grid(
      8, 8, [](int c, int r) { return c == 0 || r == 0 || c == 7 || r == 7 ? kVoid : 5; });
  const Terrain island = terrain(grid, {.eye_uv = {3.5, 3.5}, .eye_height_m = 6});
  expect_hit_at(island, ray_towards({0, 0, 0}, {2.4, 0, -1}), 2.6, 1e-14);
  expect_free(island, ray_towards({0, 0, 0}, {2.6, 0, -1}));
  expect_hit_at(island, ray_towards({0, 0, 0}, {0, -2.4, -1}), 2.6, 1e-14);
  expect_free(island, ray_towards({0, 0, 0}, {0, 2.6, -1}));
  EXPECT_FALSE(island.ground_at({3, 0}));
}

// From half-way up, the flank of a cliff is met half-way across its cell.
TEST_P(HardGrid, ACliffOfTenKilometresInOneCellIsMetWhereItStands) {
  for (const double spacing_m : {0.01, 1.0, 1000.0}) {
    const Terrain cliff =
        terrain(make_grid(9, 9, [](int c, int) { return c < 5 ? 0 : 1e4; }),
                {.eye_uv = {1, 4.3}, .spacing_m = {spacing_m, spacing_m}, .eye_height_m = 5000});
    expect_hit_at(cliff, {.direction = {1, 0, 0}}, 3.5 * spacing_m, 1e-14 * spacing_m * 10);
    expect_free(cliff, ray_towards({0, 0, 0}, {4 * spacing_m, 0, 5000.001}));
    const auto top = judged_hit(cliff, ray_towards({0, 0, 0}, {4 * spacing_m, 0, 4999.999}));
    EXPECT_TRUE(top);
  }
}

TEST_P(HardGrid, ASpikeOfOnePostIsMetInAPlainOfAnySpacing) {
  for (const double spacing_m : {0.01, 1000.0}) {
    const Place place{
        .eye_uv = {2.37, 30.1}, .spacing_m = {spacing_m, spacing_m}, .eye_height_m = 50};
    const Terrain plain =
        terrain(make_grid(40, 40, [](int c, int r) { return c == 21 && r == 9 ? 100 : 0; }), place);
    const glm::dvec2 spike_m = ground_of(place, {21, 9});
    for (const double height_m : {51.0, 75.0, 99.0, 99.999}) {
      const glm::dvec3 target(spike_m, height_m - 50);
      const auto hit = judged_hit(plain, ray_towards({0, 0, 0}, target));
      ASSERT_TRUE(hit);
      EXPECT_LT(glm::length(hit->uv - glm::dvec2(21, 9)), 1);
    }
    expect_free(plain, ray_towards({0, 0, 0}, glm::dvec3(spike_m, 50.001)));
  }
}

// How far the point of a ray is from the ground above or below it.
double clearance_m(const Terrain& terrain, const Ray& ray, double t) {
  const oracle::Profile profile = oracle::profile(terrain, ray);
  for (const oracle::Span& span : profile.spans) {
    if (span.from_t <= t && t <= span.to_t)
      return static_cast<double>(std::fabs(profile.clearance_m(span, t)));
  }
  return std::numeric_limits<double>::infinity();
}

// The surface is found to ten nanometres, a few units in the last place of the coordinates.
TEST_P(HardGrid, MillimetreReliefIsResolvedAMillionMetresFromTheOrigin) {
  const auto ripples = [](int c, int r) { return 1e-3 * ((c + 2 * r) % 3); };
  const Place place{.eye_uv = {-1e6, 1e6}, .eye_height_m = 1e6};
  const Terrain far_away = terrain(make_grid(30, 30, ripples), place);
  int hits = 0;
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 from(1e6 + 0.1 * i, 1e6 - 15 + 0.05 * i, -1e6 + 2e-3);
    const Ray ray = ray_towards(from, from + glm::dvec3(std::cos(i), std::sin(i), -1e-3));
    const auto hit = judged_hit(far_away, ray);
    if (!hit) continue;
    EXPECT_LT(clearance_m(far_away, ray, hit->distance_m), 1e-8);
    ++hits;
  }
  EXPECT_GT(hits, 100);
}

// Stretched by a power of two, with its eye and its rays, a scene has the same hits bit for bit.
TEST_P(HardGrid, ZScaleStretchesTheSceneAndNothingElse) {
  const HeightGrid hills =
      make_grid(20, 20, [](int c, int r) { return 8 * std::sin(c * 0.7) * std::cos(r * 0.9); });
  for (const double z_scale : {1.0 / 1024, 1024.0}) {
    const Place place{.eye_uv = {9.5, 9.5}, .eye_height_m = 12};
    const Terrain plain = terrain(hills, place);
    Place stretched_place = place;
    stretched_place.z_scale = z_scale;
    stretched_place.eye_height_m *= z_scale;
    const Terrain stretched = terrain(hills, stretched_place);
    for (const Ray& ray : rays_all_round(90)) {
      const glm::dvec3 target = 5.0 * ray.direction - glm::dvec3(0, 0, 10);
      const auto hit = judged_hit(plain, ray_towards({0, 0, 0}, target));
      const auto same =
          judged_hit(stretched, ray_towards({0, 0, 0}, {target.x, target.y, target.z * z_scale}));
      ASSERT_TRUE(hit && same);
      EXPECT_EQ(hit->cell, same->cell);
      EXPECT_NEAR(hit->uv.x, same->uv.x, 1e-12);
      EXPECT_NEAR(hit->uv.y, same->uv.y, 1e-12);
    }
  }
}

TEST_P(HardGrid, ACheckerboardOfAKilometreAgreesWithTheOracle) {
  const HeightGrid board =
      make_grid(33, 33, [](int c, int r) { return (c + r) % 2 == 0 ? 1000 : 0; });
  int hits = 0;
  for (const double eye_height_m : {1.0, 500.0, 999.0, 1001.0}) {
    const Terrain spikes =
        terrain(board, {.eye_uv = {17, 16}, .spacing_m = {100, 100}, .eye_height_m = eye_height_m});
    for (const Ray& ray : rays_all_round(64)) {
      for (const double rise : {-1.0, -0.01, 0.0, 0.3})
        hits += judged_hit(spikes, ray_towards({0, 0, 0}, ray.direction + glm::dvec3(0, 0, rise)))
                    ? 1
                    : 0;
    }
  }
  EXPECT_GT(hits, 500);
}

TEST_P(HardGrid, HeightsOfTenToTheThirtyStayFinite) {
  const HeightGrid board =
      make_grid(8, 8, [](int c, int r) { return (c + r) % 2 == 0 ? 1e30 : -1e30; });
  const Terrain above = terrain(board, {.eye_uv = {3, 3}, .eye_height_m = 3e30});
  expect_hit_at(above, {.direction = {0, 0, -1}}, 2e30, 1e24);
  expect_free(above, ray_towards({0, 0, 0}, {0, 1, 1e30}));
  const Terrain between = terrain(board, {.eye_uv = {3, 4}, .eye_height_m = 0});
  expect_hit_at(between, {.direction = {1, 0, 0}}, 0.5, 1e-12);
}

TEST_P(HardGrid, RaysThatBeginBeyondTheReachComeInOrStayOut) {
  const Terrain plain =
      terrain(make_grid(5, 5, [](int, int) { return 0; }), {.eye_uv = {2, 2}, .eye_height_m = 1});
  expect_hit_at(plain, ray_towards({1e5, 0.3, 1e5 - 1}, {0, 0.3, -1}), 1e5 * std::sqrt(2.0), 1e-9);
  expect_free(plain, ray_towards({1e5, 0.3, 1e5}, {2e5, 0.3, 0}));
  expect_free(plain, ray_towards({1e5, 0, 0}, {1e5, 1, 0}));
  expect_free(plain, {{1e5, 0, 0}, {0, 0, -1}});
}

TEST_P(HardGrid, ARayOfNoLengthMeetsOnlyTheGroundItStandsOn) {
  const HeightGrid plain = make_grid(5, 5, [](int, int) { return 7; });
  const Ray point{.direction = {0.6, 0, -0.8}, .length_m = 0};
  expect_free(terrain(plain, {.eye_uv = {1.5, 2}, .eye_height_m = 7.1}), point);
  expect_ends_below(terrain(plain, {.eye_uv = {1.5, 2}, .eye_height_m = 6.9}), point);
  expect_free(terrain(plain, {.eye_uv = {-1.5, 2}, .eye_height_m = 6.9}), point);
}

TEST_P(HardGrid, NothingToSeeIsAMissOrRefused) {
  const VerticalFrame frame;
  const Terrain empty({}, frame, GetParam());
  EXPECT_FALSE(empty.first_hit({.direction = {0, 0, -1}}));
  EXPECT_FALSE(empty.occluded({}));
  EXPECT_FALSE(empty.ground_at({0, 0}));
  const auto flat = [](int, int) { return 1; };
  EXPECT_THROW(terrain(make_grid(1, 8, flat), {}), InputError);
  EXPECT_THROW(terrain(make_grid(8, 1, flat), {}), InputError);
  EXPECT_THROW(terrain(HeightGrid{}, {}), InputError);
  EXPECT_THROW(terrain(make_grid(4, 4, [](int, int) { return kVoid; }), {}), InputError);
}

INSTANTIATE_TEST_SUITE_P(Models, HardGrid, testing::ValuesIn(kSurfaceModels), model_name);

}  // namespace
}  // namespace terrview

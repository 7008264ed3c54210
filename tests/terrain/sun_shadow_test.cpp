#include "terrain/sun_shadow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include <glm/geometric.hpp>

#include "terrain/occlusion.h"
#include "terrain/sun_map.h"
#include "terrain/vector_limits.h"
#include "terrain/view_transform.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/random_scene.h"
#include "tests/support/scenes.h"
#include "tests/terrain/sun_shadows.h"

namespace terrview {
namespace {

TEST(SunShadow, IsThatOfSingleRays) {
  for (const SurfaceModel model : kSurfaceModels) {
    const Seen seen = expect_shadows(
        1, [&](Random& random) { return random_terrain(random, model, Position::general); });
    if (model == SurfaceModel::band) {
      EXPECT_EQ(seen.suns, 0);
      continue;
    }
    EXPECT_GT(seen.suns, fewer_if_sanitized(200));
    EXPECT_GT(seen.lit, fewer_if_sanitized(10000));
    EXPECT_GT(seen.shaded, fewer_if_sanitized(1000));
    EXPECT_GT(seen.unknown, fewer_if_sanitized(1000));
  }
}

TEST(SunShadow, IsSoWhereGridLinesAndPostsLieUnderTheEye) {
  const Seen seen = expect_shadows(2, [](Random& random) {
    return random_terrain(random, SurfaceModel::hyperboloid, Position::special);
  });
  EXPECT_GT(seen.lit, fewer_if_sanitized(10000));
  EXPECT_GT(seen.shaded, fewer_if_sanitized(1000));
}

// More strips and panels of lines than one.
TEST(SunShadow, IsSoOverManyStripsInEveryDirection) {
  Random random(5);
  Seen seen;
  for (const double voids : {0.0, 0.01}) {
    const Terrain terrain = wide_hills(1100, {.eye_height_m = 500}, voids);
    for (int eighth = 0; eighth < 8; ++eighth)
      for (const double off_rad : {0.0, 0.3})
        expect_shadows_of_single_rays(terrain, sun_at(eighth * std::acos(-1) / 4 + off_rad, 0.2),
                                      ground_under(terrain, random, 3000), seen);
  }
  EXPECT_EQ(seen.suns, 32);
  EXPECT_GT(seen.lit, 3 * seen.unknown);
  EXPECT_GT(seen.shaded, seen.unknown / 10);
}

TEST(SunShadow, IsSoFarAwayOnACurvedEarth) {
  Random random(6);
  Seen seen;
  for (const double refraction : {0.0, 0.13, 0.9}) {
    const Terrain terrain = wide_hills(1100, {.eye_height_m = 500,
                                              .north_curvature_per_m = 1.003 * kEarth_per_m,
                                              .east_curvature_per_m = 0.997 * kEarth_per_m,
                                              .refraction = refraction});
    for (const double elevation_rad : {0.03, 0.1, 0.35, 1.2}) {
      const glm::dvec3 to_sun = sun_at(random.uniform(0, 6.3), elevation_rad);
      expect_shadows_of_single_rays(terrain, to_sun, ground_under(terrain, random, 3000), seen);
    }
  }
  EXPECT_EQ(seen.suns, 12);
  EXPECT_GT(seen.lit, 2 * seen.unknown);
  EXPECT_GT(seen.shaded, 100);
}

// Further than the vectors' series of the round Earth reach.
TEST(SunShadow, IsSoAThousandKilometresAway) {
  Random random(8);
  Seen seen;
  const HeightGrid grid = make_grid(60, 60, [&](int, int) { return random.uniform(0, 60000); });
  const auto map = std::make_shared<const AffineGroundMap>(
      glm::dvec2(30.3, 29.6), glm::dmat2(4e-5, 0, 0, -4e-5), glm::ivec2(60, 60));
  const Terrain terrain({{.grid = std::make_shared<const HeightGrid>(grid), .map = map}},
                        {.eye_height_m = 70000,
                         .north_curvature_per_m = kEarth_per_m,
                         .east_curvature_per_m = kEarth_per_m},
                        SurfaceModel::hyperboloid);
  ASSERT_FALSE(within_series_limit(terrain));
  const std::vector<Hit> hits = ground_under(terrain, random, 1000);
  int stopped = 0;
  for (const double azimuth_rad : {0.5, 2.5, 4.5}) {
    const glm::dvec3 to_sun = sun_at(azimuth_rad, 0.8);
    expect_shadows_of_single_rays(terrain, to_sun, hits, seen);
    for (const Hit& hit : hits) {
      const glm::dvec3 direction = direction_at(terrain.frame(), hit.position_m, to_sun);
      stopped += terrain.occluded({terrain.leave(hit, direction).origin_m, direction}) ? 1 : 0;
    }
  }
  EXPECT_EQ(seen.suns, 3);
  EXPECT_GT(stopped, 300);
}

TEST(SunShadow, IsSoUnderEveryInstructionSetWithTheSameMap) {
  Random random(7);
  const Terrain terrain = wide_hills(700, {.eye_height_m = 500}, 0.001);
  const glm::dvec3 to_sun = sun_at(2, 0.1);
  const std::vector<Hit> hits = ground_under(terrain, random, 3000);
  std::vector<std::vector<std::uint32_t>> maps;
  under_every_instruction_set([&] {
    Seen seen;
    expect_shadows_of_single_rays(terrain, to_sun, hits, seen);
    EXPECT_GT(seen.lit, 1000);
    const auto map = SunMap::make(terrain, to_sun);
    maps.emplace_back(map->words(), map->words() + map->bytes() / sizeof(std::uint32_t));
  });
  for (const auto& map : maps) EXPECT_EQ(map, maps[0]);
}

// Below the eye the curvature of the Earth turns with the azimuth.
TEST(SunShadow, IsKnownAFewPostsFromThePointBelowTheEye) {
  constexpr int kPosts = 101;
  const glm::dvec2 eye_uv(50.3, 49.6);
  const auto grid = std::make_shared<const HeightGrid>(
      make_grid(kPosts, kPosts, [](int, int) { return 1500.0F; }));
  const auto ground = std::make_shared<const AffineGroundMap>(eye_uv, glm::dmat2(0.01, 0, 0, -0.01),
                                                              glm::ivec2(kPosts));
  const Terrain terrain({{grid, ground}},
                        {.eye_height_m = 2500,
                         .north_curvature_per_m = 1.003 * kEarth_per_m,
                         .east_curvature_per_m = 0.997 * kEarth_per_m},
                        SurfaceModel::hyperboloid);
  std::vector<std::vector<std::uint32_t>> maps;
  under_every_instruction_set([&] {
    const auto map = SunMap::make(terrain, sun_at(2, 0.35));
    ASSERT_TRUE(map);
    maps.emplace_back(map->words(), map->words() + map->bytes() / sizeof(std::uint32_t));
    for (int row = 1; row < kPosts - 2; ++row) {
      for (int column = 1; column < kPosts - 2; ++column) {
        const glm::dvec2 uv = glm::dvec2(column, row) + 0.5;
        const bool is_far = glm::distance(uv, eye_uv) > 6;
        if (is_far) {
          EXPECT_EQ(map->at(uv, 1500), Sunlight::lit) << column << ", " << row;
        }
      }
    }
    EXPECT_EQ(map->at({50.5, 49.5}, 1500), Sunlight::unknown);
  });
  for (const auto& map : maps) EXPECT_EQ(map, maps[0]);
}

TEST(SunShadow, HasTheSameMapInWhateverOrderItsPartsAreMade) {
  const Terrain terrain = wide_hills(1100, {.eye_height_m = 500});
  const glm::dvec3 to_sun = sun_at(4, 0.2);
  const auto backwards = [](int count, const std::function<void(int)>& work) {
    for (int i = count; i-- > 0;) work(i);
  };
  const auto map = SunMap::make(terrain, to_sun);
  const auto other = SunMap::make(terrain, to_sun, backwards);
  ASSERT_EQ(map->bytes(), other->bytes());
  EXPECT_TRUE(std::equal(map->words(), map->words() + map->bytes() / 4, other->words()));
}

// One post in a plain, walls, steps, a checkerboard, all in several units.
TEST(SunShadow, IsSoOnHardGround) {
  constexpr int kPosts = 60;
  const std::vector<std::function<double(int, int)>> grounds{
      [](int, int) { return 100.0; },
      [](int column, int row) { return column == 30 && row == 31 ? 1.0 : 0.0; },
      [](int column, int) { return column % 7 == 0 ? 3.0 : 0.0; },
      [](int column, int row) { return std::floor((column + row) / 9.0); },
      [](int column, int row) { return (column + row) % 2; },
      [](int column, int row) { return column > 25 && column < 35 && row > 20 && row < 33; },
      [](int column, int row) { return column > 25 && row > 20 ? std::nan("") : column * 0.01; }};
  Random random(9);
  Seen seen;
  for (const auto& ground : grounds) {
    for (const double unit_m : {1e-3, 1.0, 1e4, 1e30}) {
      for (const double spacing_m : {0.01, 30.0, 1000.0}) {
        const auto height_m = [&](int column, int row) { return unit_m * ground(column, row); };
        const Terrain terrain =
            make_terrain(make_grid(kPosts, kPosts, height_m),
                         {.eye_uv = {1e5, 3e5}, .spacing_m = {spacing_m, 0.7 * spacing_m}},
                         SurfaceModel::hyperboloid);
        Random places(10);
        std::vector<Hit> hits;
        const auto [j, grid] = std::pair(*terrain.layers()[0].map->linear(), kPosts - 1);
        while (hits.size() < 200) {
          const glm::dvec2 uv(places.uniform(0, grid), places.uniform(0, grid));
          const glm::dvec2 at_m = glm::inverse(j) * (uv - terrain.layers()[0].map->to_grid({0, 0}));
          const auto here = terrain.ground_at(at_m);
          if (here) hits.push_back({0, {at_m, here->scene_height_m}, 0, here->cell, here->uv});
        }
        for (int i = 0; i < 6; ++i)
          expect_shadows_of_single_rays(terrain, random_sun(random), hits, seen);
      }
    }
  }
  EXPECT_GT(seen.lit, 10000);
  EXPECT_GT(seen.shaded, 100);
}

TEST(SunShadow, KnowsThatAllOfAPlainIsLit) {
  const Terrain terrain =
      make_terrain(make_grid(50, 40, [](int, int) { return 7; }), {}, SurfaceModel::hyperboloid);
  const auto map = SunMap::make(terrain, sun_at(1, 0.01));
  ASSERT_TRUE(map);
  for (int row = 0; row < 39; ++row)
    for (int column = 0; column < 49; ++column)
      EXPECT_EQ(map->at({column + 0.5, row + 0.5}, 7), Sunlight::lit) << column << ", " << row;
}

// A wall of 10 m across the sun's way, which rises by a metre over a post.
TEST(SunShadow, KnowsTheShadowOfAWall) {
  const auto height_m = [](int, int row) { return row == 30 ? 10 : 0; };
  const Terrain terrain =
      make_terrain(make_grid(50, 50, height_m), {.spacing_m = {1, 1}}, SurfaceModel::hyperboloid);
  const auto map = SunMap::make(terrain, sun_at(0, std::atan(1.0)));  // in the north
  ASSERT_TRUE(map);
  for (int column = 2; column < 47; ++column) {
    for (int row = 0; row < 49; ++row) {
      if (row == 28 || row == 29 || row == 30) continue;  // the wall and its feet
      const double edge = 40 - (row + 0.5);               // how high the shadow is
      for (const double height : {0.0, 0.5, 3.0, 9.0}) {
        if (row >= 31 && std::abs(height - edge) < 0.01) continue;
        const bool shaded = row >= 31 && height < edge;
        EXPECT_EQ(map->at({column + 0.5, row + 0.5}, height),
                  shaded ? Sunlight::shaded : Sunlight::lit)
            << column << ", " << row << ", " << height;
      }
    }
  }
}

TEST(SunShadow, HasNoMapForASunBelowTheGroundOrInTheZenith) {
  const Terrain terrain =
      make_terrain(make_grid(5, 5, [](int, int) { return 0; }), {}, SurfaceModel::hyperboloid);
  EXPECT_FALSE(SunMap::make(terrain, sun_at(1, -0.1)));
  EXPECT_FALSE(SunMap::make(terrain, sun_at(1, 0)));
  EXPECT_FALSE(SunMap::make(terrain, {0, 0, 1}));
  EXPECT_TRUE(SunMap::make(terrain, sun_at(1, 0.1)));
}

TEST(SunShadow, CostsAFractionOfTheWorkWithoutAMap) {
  Random random(12);
  const Terrain terrain = wide_hills(500, {.eye_height_m = 500});
  const glm::dvec3 to_sun = sun_at(2, 0.35);
  const auto map = SunMap::make(terrain, to_sun);
  std::vector<Ray> rays;
  std::vector<glm::dvec3> points_m;
  for (const Hit& hit : ground_under(terrain, random, 5000)) {
    rays.push_back(terrain.leave(hit, to_sun));
    points_m.push_back(rays.back().origin_m);
  }
  std::vector<std::uint8_t> stopped(rays.size());
  TraceCounts marched;
  occluded(terrain, rays, stopped, marched);
  TraceCounts looked_up;
  shaded(terrain, *map, points_m, stopped, looked_up);
  EXPECT_LT(4 * (looked_up.tests + looked_up.nodes), marched.tests + marched.nodes);
}

}  // namespace
}  // namespace terrview

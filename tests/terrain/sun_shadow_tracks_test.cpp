// Shadows of maps of the sun on bent tracks, in parts of a grid, in the air and over holes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include <glm/vector_relational.hpp>

#include "terrain/sun_map.h"
#include "terrain/sun_shadow.h"
#include "terrain/view_transform.h"
#include "tests/support/parabolic_map.h"
#include "tests/support/random_scene.h"
#include "tests/support/scenes.h"
#include "tests/terrain/sun_shadows.h"

namespace terrview {
namespace {

TEST(SunShadow, IsSoOnBentTracks) {
  const Seen parabolas = expect_shadows(3, [](Random& random) {
    return random_parabolic_terrain(random, SurfaceModel::hyperboloid);
  });
  EXPECT_GT(parabolas.suns, fewer_if_sanitized(100));
  EXPECT_GT(parabolas.lit, fewer_if_sanitized(1000));
  expect_shadows(
      4, [](Random& random) { return random_bent_terrain(random, SurfaceModel::hyperboloid); });
}

// Rays that leave the grid and come back to it below its ground, though all of it near their tracks
// faces the sun.
TEST(SunShadow, IsSoWhereTracksComeBackBelowTheGround) {
  constexpr int kRows = 501;
  const auto height_m = [](int, int row) { return std::clamp(0.2 * (350 - row), 0.0, 40.0); };
  const auto grid = std::make_shared<const HeightGrid>(make_grid(13, kRows, height_m));
  // Tracks from south to north bulge over the grid's western border.
  const auto map =
      std::make_shared<const ParabolicGroundMap>(glm::dvec2(0, 250), 1, 0.0005, 4.0 * kRows);
  const Terrain terrain({{grid, map}}, {.eye_height_m = 100}, SurfaceModel::hyperboloid);
  Random random(17);
  std::vector<Hit> hits;
  while (hits.size() < 2000) {
    const glm::dvec2 at_m(random.uniform(-25, 0), random.uniform(150, 250));
    const auto ground = terrain.ground_at(at_m);
    if (!ground) continue;
    const double z_m = terrain.frame().at(at_m).z_m(ground->scene_height_m);
    hits.push_back({0, {at_m, z_m}, ground->grid, ground->cell, ground->uv});
  }
  Seen seen;
  expect_shadows_of_single_rays(terrain, sun_at(std::acos(-1), 0.08), hits, seen);
  EXPECT_GT(seen.shaded, 500);
}

// Far more lines than tracks take to stray by a post, with walls of a post's width.
TEST(SunShadow, IsSoAlongTracksThatBendALittle) {
  Random random(18);
  Seen seen;
  for (int i = 0; i < 12; ++i) {
    const int columns = random.integer(30, 300);
    const int rows = random.integer(30, 300);
    const double rough = random.log_uniform(0.03, 1);
    const auto height_m = [&](int column, int row) {
      const bool wall = random.chance(0.003);
      return 5 * std::sin(column * 0.11) * std::cos(row * 0.07) + random.uniform(0, rough) +
             (wall ? random.uniform(0, 20) : 0);
    };
    const auto grid = std::make_shared<const HeightGrid>(make_grid(columns, rows, height_m));
    const glm::dvec2 eye_uv(random.uniform(0, columns), random.uniform(0, rows));
    const double reach_m = 1.5 * (columns + rows);
    const double bend_per_m = random.sign() * random.log_uniform(0.02, 0.6) / reach_m;
    const auto map = std::make_shared<const ParabolicGroundMap>(eye_uv, 1, bend_per_m, reach_m);
    const Terrain terrain({{grid, map}}, {.eye_height_m = 30}, SurfaceModel::triangles);
    for (int sun = 0; sun < 3; ++sun)
      expect_shadows_of_single_rays(terrain,
                                    sun_at(random.uniform(0, 6.3), random.uniform(0.05, 0.7)),
                                    ground_under(terrain, random, 1000), seen);
  }
  EXPECT_GT(seen.suns, 25);
  EXPECT_GT(seen.lit, 4000);
  EXPECT_GT(seen.shaded, 1000);
}

// Of a part, with the ground towards the sun as far as shadows reach.
TEST(SunShadow, IsSoInAPartOfTheMap) {
  Random random(15);
  Seen whole_seen;
  Seen part_seen;
  Seen beside_seen;
  for (const double curvature : {0.0, kEarth_per_m}) {
    const Terrain terrain = wide_hills(1100, {.eye_height_m = 500,
                                              .north_curvature_per_m = curvature,
                                              .east_curvature_per_m = curvature});
    for (int i = 0; i < 8; ++i) {
      const glm::dvec3 to_sun = sun_at(random.uniform(0, 6.3), random.uniform(0.1, 0.6));
      CellRect part{{random.integer(0, 800), random.integer(0, 800)}, {}};
      part.last = part.first + glm::ivec2(random.integer(100, 190), random.integer(100, 190));
      std::vector<Hit> hits = ground_under(terrain, random, 20000);
      const std::vector<Hit> all_hits(hits.begin(), hits.begin() + 3000);
      std::erase_if(hits, [&](const Hit& hit) {
        return glm::any(glm::lessThan(hit.cell, part.first)) ||
               glm::any(glm::greaterThan(hit.cell, part.last));
      });
      const auto whole = SunMap::make(terrain, to_sun);
      const auto map = SunMap::make(terrain, to_sun, one_by_one, part);
      ASSERT_TRUE(map);
      EXPECT_TRUE(map->cells().holds(part.first) && map->cells().holds(part.last));
      EXPECT_LT(map->bytes(), whole->bytes() / 8);
      expect_shadows_with(*whole, terrain, hits, whole_seen);
      expect_shadows_with(*map, terrain, hits, part_seen);
      expect_shadows_with(*map, terrain, all_hits, beside_seen);
    }
  }
  EXPECT_GT(part_seen.lit, 1000);
  EXPECT_GE(part_seen.lit, whole_seen.lit);
  EXPECT_GE(part_seen.shaded, 0.95 * whole_seen.shaded);
}

// Whatever part is asked for: of one cell, over the grid's border, beyond it, or turned inside out.
TEST(SunShadow, IsSoInPartsAtTheBorder) {
  Random random(25);
  Seen seen;
  const Terrain terrain = wide_hills(300, {.eye_height_m = 500});
  const std::vector<Hit> hits = ground_under(terrain, random, 4000);
  for (const double azimuth : {0.3, 1.2, 2.0, 2.8, 3.6, 4.4, 5.2, 6.0})
    for (const CellRect& part : {CellRect{{150, 140}, {150, 140}}, CellRect{{-50, 200}, {90, 4000}},
                                 CellRect{{298, 0}, {298, 298}}, CellRect{{400, -900}, {500, -800}},
                                 CellRect{{200, 200}, {100, 100}}, CellRect{{0, 0}, {298, 0}}}) {
      const auto map = SunMap::make(terrain, sun_at(azimuth, 0.1), one_by_one, part);
      ASSERT_TRUE(map);
      EXPECT_LT(map->bytes(), 299 * 299 * 4 / 2);
      expect_shadows_with(*map, terrain, hits, seen);
    }
  EXPECT_GT(seen.lit, 1000);
  EXPECT_GT(seen.shaded, 1000);
}

// Rays that begin in the air.
TEST(SunShadow, IsSoAboveTheGround) {
  Random random(14);
  std::int64_t rays = 0;
  std::int64_t work = 0;
  for (int i = 0; i < 200; ++i) {
    const Terrain terrain = random_terrain(random, SurfaceModel::hyperboloid, Position::general);
    const glm::dvec3 to_sun = random_sun(random);
    const auto map = SunMap::make(terrain, to_sun);
    if (!map) continue;
    std::vector<glm::dvec3> points_m;
    for (const Hit& hit : ground_under(terrain, random, 200)) {
      const double range_m = terrain.height_range_m().y - terrain.height_range_m().x;
      points_m.push_back(hit.position_m);
      points_m.back().z += random.uniform(0.001, 1) * (range_m + 1e-3 * terrain.reach_m());
    }
    std::vector<std::uint8_t> stopped(points_m.size());
    TraceCounts counts;
    shaded(terrain, *map, points_m, stopped, counts);
    rays += static_cast<std::int64_t>(points_m.size());
    work += counts.tests + counts.nodes;
    for (std::size_t k = 0; k < points_m.size(); ++k) {
      const Ray ray{points_m[k], direction_at(terrain.frame(), points_m[k], to_sun)};
      EXPECT_EQ(stopped[k] != 0, terrain.occluded(ray));
    }
  }
  EXPECT_GT(rays, 1000);
  EXPECT_LT(work, 2 * rays);
}

// Rays that begin in holes and beside the grid, and come to walls from below, from above, or not.
TEST(SunShadow, IsSoWhereThereIsNoGround) {
  Random random(16);
  int stopped_rays = 0;
  int free_rays = 0;
  for (int i = 0; i < 300; ++i) {
    const SurfaceModel model = SurfaceModel::hyperboloid;
    const Terrain terrain = i % 3 == 0 ? random_parabolic_terrain(random, model)
                                       : random_terrain(random, model, Position::general);
    const glm::dvec3 to_sun = random_sun(random);
    const auto map = SunMap::make(terrain, to_sun);
    if (!map) continue;
    const VerticalFrame& frame = terrain.frame();
    const glm::dvec2 range_m = terrain.height_range_m();
    std::vector<glm::dvec3> points_m;
    for (int k = 0; k < 400; ++k) {
      const double reach_m = 0.7 * terrain.reach_m();
      const glm::dvec2 at(random.uniform(-reach_m, reach_m), random.uniform(-reach_m, reach_m));
      if (terrain.ground_at(at)) continue;
      const double height_m =
          range_m.x + random.uniform(-1, 1) * (range_m.y - range_m.x + 1e-3 * reach_m);
      points_m.emplace_back(at, frame.at(at).z_m(height_m));
    }
    std::vector<std::uint8_t> stopped(points_m.size());
    TraceCounts counts;
    shaded(terrain, *map, points_m, stopped, counts);
    for (std::size_t k = 0; k < points_m.size(); ++k) {
      const bool expected =
          terrain.occluded({points_m[k], direction_at(frame, points_m[k], to_sun)});
      EXPECT_EQ(stopped[k] != 0, expected);
      const glm::dvec2 at(points_m[k]);
      const double height = frame.at(at).scene_height_m(points_m[k].z) / frame.z_scale;
      const Sunlight known = map->at(terrain.layers()[0].map->to_grid(at), height);
      EXPECT_TRUE(known == Sunlight::unknown || (known == Sunlight::shaded) == expected);
      (expected ? stopped_rays : free_rays) += 1;
    }
  }
  EXPECT_GT(stopped_rays, 1000);
  EXPECT_GT(free_rays, 1000);
}

}  // namespace
}  // namespace terrview

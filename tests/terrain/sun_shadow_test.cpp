#include "terrain/sun_shadow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "terrain/occlusion.h"
#include "terrain/sun_map.h"
#include "terrain/view_transform.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/parabolic_map.h"
#include "tests/support/random_scene.h"
#include "tests/support/scenes.h"

namespace terrview {
namespace {

constexpr double kEarth_per_m = 1 / 6.37e6;

struct Seen {
  int suns = 0;  // that have a map
  int lit = 0, shaded = 0, unknown = 0;
};

glm::dvec3 sun_at(double azimuth_rad, double elevation_rad) {
  return {std::cos(elevation_rad) * std::sin(azimuth_rad),
          std::cos(elevation_rad) * std::cos(azimuth_rad), std::sin(elevation_rad)};
}

// Along grid lines and diagonals too.
glm::dvec3 random_sun(Random& random) {
  const double azimuth_rad =
      random.chance(0.3) ? random.integer(0, 7) * std::acos(-1) / 4 : random.uniform(0, 6.3);
  return sun_at(azimuth_rad, random.log_uniform(1e-3, 1.5));
}

// What an eye at `from_m` sees, by polylines where tracks bend.
std::vector<Hit> ground_seen(const Terrain& terrain, Random& random, const glm::dvec3& from_m) {
  std::vector<Hit> hits;
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 down(random.uniform(-1, 1), random.uniform(-1, 1),
                          -random.log_uniform(0.01, 1));
    const auto hit = terrain.first_hit({.origin_m = from_m, .direction = down});
    if (hit) hits.push_back(*hit);
  }
  return hits;
}

// Places all over the ground.
std::vector<Hit> ground_under(const Terrain& terrain, Random& random, int count) {
  std::vector<Hit> hits;
  const double reach_m = terrain.reach_m();
  for (int i = 0; i < 20 * count && static_cast<int>(hits.size()) < count; ++i) {
    const glm::dvec2 at(random.uniform(-reach_m, reach_m), random.uniform(-reach_m, reach_m));
    const auto ground = terrain.ground_at(at);
    if (!ground) continue;
    const double z_m = terrain.frame().at(at).z_m(ground->scene_height_m);
    hits.push_back({0, {at, z_m}, ground->grid, ground->cell, ground->uv});
  }
  return hits;
}

// The heights over a place between which the map knows nothing: rays from there, too, meet what it
// says.
void expect_bounds_of_single_rays(const SunMap& map, const Terrain& terrain,
                                  const glm::dvec3& from_m) {
  const glm::dvec2 at_m(from_m);
  const glm::dvec2 uv = terrain.layers()[0].map->to_grid(at_m);
  const VerticalFrame& frame = terrain.frame();
  const glm::dvec2 range = terrain.height_range_m() / frame.z_scale;
  const double ground = frame.at(at_m).scene_height_m(from_m.z) / frame.z_scale;
  for (const Sunlight beyond : {Sunlight::lit, Sunlight::shaded}) {
    double known = beyond == Sunlight::lit ? 2 * range.y - range.x + 1 : ground;
    double other = beyond == Sunlight::lit ? ground : 2 * range.y - range.x + 1;
    if (map.at(uv, known) != beyond || map.at(uv, other) == beyond) continue;
    for (int i = 0; i < 30; ++i) {
      const double middle = (known + other) / 2;
      (map.at(uv, middle) == beyond ? known : other) = middle;
    }
    if (known <= ground) continue;
    const glm::dvec3 point_m(at_m, frame.at(at_m).z_m(known * frame.z_scale));
    const Ray ray{point_m, direction_at(frame, point_m, map.to_sun())};
    EXPECT_EQ(terrain.occluded(ray), beyond == Sunlight::shaded) << known << " over " << ground;
  }
}

void expect_shadows_with(const SunMap& map, const Terrain& terrain, const std::vector<Hit>& hits,
                         Seen& seen) {
  const glm::dvec3 to_sun = map.to_sun();
  std::vector<glm::dvec3> points_m;
  for (const Hit& hit : hits)
    points_m.push_back(
        terrain.leave(hit, direction_at(terrain.frame(), hit.position_m, to_sun)).origin_m);
  std::vector<std::uint8_t> stopped(points_m.size());
  TraceCounts counts;
  shaded(terrain, map, points_m, stopped, counts);
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const Ray ray{points_m[i], direction_at(terrain.frame(), points_m[i], to_sun)};
    const bool expected = terrain.occluded(ray);
    EXPECT_EQ(stopped[i] != 0, expected)
        << "at " << hits[i].uv.x << ", " << hits[i].uv.y << " of "
        << terrain.layers()[0].grid->columns << " x " << terrain.layers()[0].grid->rows;
    const glm::dvec2 at_m(points_m[i]);
    const double height =
        terrain.frame().at(at_m).scene_height_m(points_m[i].z) / terrain.frame().z_scale;
    const glm::dvec2 uv = terrain.layers()[0].map->to_grid(at_m);
    const Sunlight known = map.at(uv, height);
    EXPECT_FALSE(map.lights(hits[i]) && expected);
    EXPECT_TRUE(!map.lights(hits[i]) || glm::ivec2(glm::floor(uv)) == hits[i].cell)
        << uv.x << ", " << uv.y;
    if (known == Sunlight::unknown)
      ++seen.unknown;
    else
      EXPECT_EQ(known == Sunlight::shaded, expected);
    if (i % 4 == 0) expect_bounds_of_single_rays(map, terrain, points_m[i]);
    seen.lit += known == Sunlight::lit ? 1 : 0;
    seen.shaded += known == Sunlight::shaded ? 1 : 0;
  }
}

void expect_shadows_of_single_rays(const Terrain& terrain, const glm::dvec3& to_sun,
                                   const std::vector<Hit>& hits, Seen& seen) {
  const auto map = SunMap::make(terrain, to_sun);
  if (!map) return;
  ++seen.suns;
  expect_shadows_with(*map, terrain, hits, seen);
}

Seen expect_shadows(std::uint64_t seed, const std::function<Terrain(Random&)>& make) {
  Random random(seed);
  Seen seen;
  for (int i = 0; i < 300; ++i) {
    const Terrain terrain = make(random);
    std::vector<Hit> hits = ground_under(terrain, random, 200);
    const glm::dvec3 above_m(0, 0, terrain.ceiling_m() + 0.1 * terrain.reach_m());
    for (const Hit& hit : ground_seen(terrain, random, above_m)) hits.push_back(hit);
    for (int j = 0; j < 4; ++j)
      expect_shadows_of_single_rays(terrain, random_sun(random), hits, seen);
    if (testing::Test::HasFailure()) {
      ADD_FAILURE() << "seed " << seed << ", terrain " << i;
      break;
    }
  }
  return seen;
}

TEST(SunShadow, IsThatOfSingleRays) {
  for (const SurfaceModel model : kSurfaceModels) {
    const Seen seen = expect_shadows(
        1, [&](Random& random) { return random_terrain(random, model, Position::general); });
    if (model == SurfaceModel::band) {
      EXPECT_EQ(seen.suns, 0);
      continue;
    }
    EXPECT_GT(seen.suns, 200);
    EXPECT_GT(seen.lit, 10000);
    EXPECT_GT(seen.shaded, 1000);
    EXPECT_GT(seen.unknown, 1000);
  }
}

TEST(SunShadow, IsSoWhereGridLinesAndPostsLieUnderTheEye) {
  const Seen seen = expect_shadows(2, [](Random& random) {
    return random_terrain(random, SurfaceModel::hyperboloid, Position::special);
  });
  EXPECT_GT(seen.lit, 10000);
  EXPECT_GT(seen.shaded, 1000);
}

TEST(SunShadow, IsSoOnBentTracks) {
  const Seen parabolas = expect_shadows(3, [](Random& random) {
    return random_parabolic_terrain(random, SurfaceModel::hyperboloid);
  });
  EXPECT_GT(parabolas.suns, 100);
  EXPECT_GT(parabolas.lit, 1000);
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

// Hills of 200 m, posts 30 m apart.
Terrain wide_hills(int posts, const VerticalFrame& frame, double voids = 0) {
  Random random(8);
  const auto height_m = [&](int column, int row) {
    if (random.chance(voids)) return std::nan("");
    return 300 + 100 * (std::sin(column * 0.07) + std::cos(row * 0.05 + 0.02 * column)) +
           std::sin(column * 0.9 + row * 1.3) + random.uniform(0, 2);
  };
  const Place place{.eye_uv = {posts * 0.4, posts * 0.7}, .spacing_m = {30, 30}};
  return Terrain({make_layer(make_grid(posts, posts, height_m), place)}, frame,
                 SurfaceModel::hyperboloid);
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
    for (const double elevation_rad : {0.03, 0.1, 0.35, 1.2})
      expect_shadows_of_single_rays(terrain, sun_at(random.uniform(0, 6.3), elevation_rad),
                                    ground_under(terrain, random, 3000), seen);
  }
  EXPECT_EQ(seen.suns, 12);
  EXPECT_GT(seen.lit, 2 * seen.unknown);
  EXPECT_GT(seen.shaded, 100);
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
      EXPECT_LT(std::count_if(map->words(), map->words() + map->bytes() / sizeof(std::uint32_t),
                              [](std::uint32_t word) { return word != 0; }),
                1100 * 1100 / 2);
      expect_shadows_with(*whole, terrain, hits, whole_seen);
      expect_shadows_with(*map, terrain, hits, part_seen);
      expect_shadows_with(*map, terrain, all_hits, beside_seen);
    }
  }
  EXPECT_GT(part_seen.lit, 1000);
  EXPECT_GE(part_seen.lit, whole_seen.lit);
  EXPECT_GE(part_seen.shaded, 0.95 * whole_seen.shaded);
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

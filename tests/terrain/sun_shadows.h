// Shadows of a map of the sun against those of single rays.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include <glm/common.hpp>

#include "terrain/sun_map.h"
#include "terrain/sun_shadow.h"
#include "terrain/view_transform.h"
#include "tests/support/random_scene.h"
#include "tests/support/sanitized.h"
#include "tests/support/scenes.h"

namespace terrview {

inline constexpr double kEarth_per_m = 1 / 6.37e6;

struct Seen {
  int suns = 0;  // that have a map
  int lit = 0, shaded = 0, unknown = 0;
};

inline glm::dvec3 sun_at(double azimuth_rad, double elevation_rad) {
  return {std::cos(elevation_rad) * std::sin(azimuth_rad),
          std::cos(elevation_rad) * std::cos(azimuth_rad), std::sin(elevation_rad)};
}

// Along grid lines and diagonals too.
inline glm::dvec3 random_sun(Random& random) {
  const double azimuth_rad =
      random.chance(0.3) ? random.integer(0, 7) * std::acos(-1) / 4 : random.uniform(0, 6.3);
  return sun_at(azimuth_rad, random.log_uniform(1e-3, 1.5));
}

// What an eye at `from_m` sees, by polylines where tracks bend.
inline std::vector<Hit> ground_seen(const Terrain& terrain, Random& random,
                                    const glm::dvec3& from_m) {
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
inline std::vector<Hit> ground_under(const Terrain& terrain, Random& random, int count) {
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
inline void expect_bounds_of_single_rays(const SunMap& map, const Terrain& terrain,
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

inline void expect_shadows_with(const SunMap& map, const Terrain& terrain,
                                const std::vector<Hit>& hits, Seen& seen) {
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

inline void expect_shadows_of_single_rays(const Terrain& terrain, const glm::dvec3& to_sun,
                                          const std::vector<Hit>& hits, Seen& seen) {
  const auto map = SunMap::make(terrain, to_sun);
  if (!map) return;
  ++seen.suns;
  expect_shadows_with(*map, terrain, hits, seen);
}

inline Seen expect_shadows(std::uint64_t seed, const std::function<Terrain(Random&)>& make) {
  Random random(seed);
  Seen seen;
  for (int i = 0; i < fewer_if_sanitized(300); ++i) {
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

// Hills of 200 m, posts 30 m apart.
inline Terrain wide_hills(int posts, const VerticalFrame& frame, double voids = 0) {
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

}  // namespace terrview

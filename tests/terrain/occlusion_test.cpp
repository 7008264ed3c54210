#include "terrain/occlusion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <glm/geometric.hpp>

#include "tests/support/instruction_sets.h"
#include "tests/support/judge.h"
#include "tests/support/random_scene.h"
#include "tests/support/scenes.h"

namespace terrview {
namespace {

// Anywhere, and from the ground towards a few suns, as shadows go.
std::vector<Ray> random_rays(Random& random, const Terrain& terrain, Position position) {
  std::vector<Ray> rays;
  std::vector<glm::dvec3> suns;
  for (int i = 0; i < 3; ++i) suns.push_back(random_ray(random, terrain, position).direction);
  while (rays.size() < 300) {
    const Ray ray = random_ray(random, terrain, position);
    rays.push_back(ray);
    const auto hit = terrain.first_hit(ray);
    if (!hit) continue;
    for (glm::dvec3 sun : suns) {
      if (random.chance(0.7)) sun.z = std::abs(sun.z);
      rays.push_back(terrain.leave(*hit, sun));
    }
  }
  return rays;
}

struct Answers {
  int stopped = 0;
  int free = 0;
};

void expect_answers_of_single_rays(const Terrain& terrain, const std::vector<Ray>& rays,
                                   Answers& answers) {
  std::vector<std::uint8_t> stopped(rays.size());
  TraceCounts counts;
  occluded(terrain, rays, stopped, counts);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const bool expected = terrain.occluded(rays[i]);
    EXPECT_EQ(stopped[i] != 0, expected) << oracle::to_string(rays[i]);
    ++(expected ? answers.stopped : answers.free);
  }
}

template <class MakeTerrain>
void expect_same_answers(std::uint64_t seed, Position position, const MakeTerrain& make) {
  Random random(seed);
  Answers answers;
  for (int i = 0; i < 300; ++i) {
    const Terrain terrain = make(random);
    expect_answers_of_single_rays(terrain, random_rays(random, terrain, position), answers);
    ASSERT_FALSE(testing::Test::HasFailure()) << "seed " << seed << ", terrain " << i;
  }
  EXPECT_GT(answers.stopped, 10000);
  EXPECT_GT(answers.free, 10000);
}

TEST(Occluded, AnswersAsSingleRaysDo) {
  expect_same_answers(1, Position::general, [](Random& random) {
    return random_terrain(random, SurfaceModel::hyperboloid, Position::general);
  });
}

TEST(Occluded, AnswersSoThroughPostsAndAlongLines) {
  expect_same_answers(2, Position::special, [](Random& random) {
    return random_terrain(random, SurfaceModel::hyperboloid, Position::special);
  });
}

TEST(Occluded, AnswersSoOnBentTracks) {
  expect_same_answers(3, Position::general, [](Random& random) {
    return random_parabolic_terrain(random, SurfaceModel::hyperboloid);
  });
}

TEST(Occluded, AnswersSoWhereTracksComeBack) {
  expect_same_answers(4, Position::general, [](Random& random) {
    return random_bent_terrain(random, SurfaceModel::hyperboloid);
  });
}

TEST(Occluded, AnswersSoOverSeveralGridsAndOtherSurfaces) {
  expect_same_answers(5, Position::general, [](Random& random) {
    return random_layers(random, SurfaceModel::hyperboloid);
  });
  for (const SurfaceModel model : kSurfaceModels) {
    expect_same_answers(6, Position::general, [&](Random& random) {
      return random_terrain(random, model, Position::general);
    });
  }
}

// Hills of 200 m, posts 30 m apart, far from the eye.
Terrain wide_hills(double eye_east_posts, const VerticalFrame& frame) {
  constexpr int kPosts = 500;
  const auto height_m = [](int column, int row) {
    return 300 + 100 * (std::sin(column * 0.07) + std::cos(row * 0.05 + 0.02 * column)) +
           3 * std::sin(column * 0.9 + row * 1.3);
  };
  const Place place{.eye_uv = {eye_east_posts, kPosts / 2.0}, .spacing_m = {30, 30}};
  return Terrain({make_layer(make_grid(kPosts, kPosts, height_m), place)}, frame,
                 SurfaceModel::hyperboloid);
}

// From all over the ground towards a sun.
std::vector<Ray> sun_rays(const Terrain& terrain, double elevation_rad) {
  Random random(7);
  std::vector<Ray> rays;
  const double reach_m = terrain.reach_m();
  while (rays.size() < 5000) {
    const glm::dvec2 at(random.uniform(-reach_m, reach_m), random.uniform(-reach_m, reach_m));
    const auto hit = terrain.first_hit({.origin_m = {at.x, at.y, 10000}, .direction = {0, 0, -1}});
    if (!hit) continue;
    const double azimuth_rad = 2 + random.uniform(0, 0.01);
    rays.push_back(terrain.leave(
        *hit, {std::cos(elevation_rad) * std::sin(azimuth_rad),
               std::cos(elevation_rad) * std::cos(azimuth_rad), std::sin(elevation_rad)}));
  }
  return rays;
}

constexpr double kEarth_per_m = 1 / 6.37e6;

TEST(Occluded, AnswersSoFarAwayOnACurvedEarth) {
  for (const double eye_east : {100.0, -3000.0}) {
    for (const double refraction : {-1.0, 0.0, 0.13, 0.9, 1.5}) {
      const Terrain terrain = wide_hills(eye_east, {.eye_height_m = 500,
                                                    .north_curvature_per_m = 1.003 * kEarth_per_m,
                                                    .east_curvature_per_m = 0.997 * kEarth_per_m,
                                                    .refraction = refraction});
      Answers answers;
      for (const double elevation_rad : {0.005, 0.03, 0.1, 0.35, 1.2})
        expect_answers_of_single_rays(terrain, sun_rays(terrain, elevation_rad), answers);
      EXPECT_GT(answers.stopped, 1000);
      EXPECT_GT(answers.free, 1000);
    }
  }
}

TEST(Occluded, AnswersSoBelowTheEye) {
  const Terrain terrain = wide_hills(100, {.eye_height_m = 9000,
                                           .north_curvature_per_m = 1.01 * kEarth_per_m,
                                           .east_curvature_per_m = 0.99 * kEarth_per_m});
  Random random(9);
  std::vector<Ray> rays;
  for (int i = 0; i < 5000; ++i) {
    const double away_m = random.log_uniform(1e-3, 300);
    const double azimuth_rad = random.uniform(0, 6.3);
    const glm::dvec3 below(away_m * std::sin(azimuth_rad), away_m * std::cos(azimuth_rad), 0);
    const auto hit = terrain.first_hit({.origin_m = below, .direction = {0, 0, -1}});
    ASSERT_TRUE(hit);
    const double sun_rad = random.uniform(0, 6.3);
    rays.push_back(
        terrain.leave(*hit, {std::sin(sun_rad), std::cos(sun_rad), random.uniform(0, 0.1)}));
  }
  Answers answers;
  expect_answers_of_single_rays(terrain, rays, answers);
  EXPECT_GT(answers.stopped, 1000);
  EXPECT_GT(answers.free, 1000);
}

TEST(Occluded, AnswersSoUnderEveryInstructionSet) {
  const Terrain terrain = wide_hills(100, {.eye_height_m = 500,
                                           .north_curvature_per_m = kEarth_per_m,
                                           .east_curvature_per_m = kEarth_per_m,
                                           .refraction = 0.13});
  const std::vector<Ray> rays = sun_rays(terrain, 0.1);
  std::vector<TraceCounts> work;
  under_every_instruction_set([&] {
    Answers answers;
    expect_answers_of_single_rays(terrain, rays, answers);
    std::vector<std::uint8_t> stopped(rays.size());
    occluded(terrain, rays, stopped, work.emplace_back());
  });
  for (const TraceCounts& counts : work) {
    EXPECT_EQ(counts.tests, work[0].tests);
    EXPECT_EQ(counts.nodes, work[0].nodes);
  }
}

// What a ray may not decide in single precision costs the whole walk of the single ray.
TEST(Occluded, CostsLittleMoreWorkThanTheSingleRay) {
  const Terrain terrain = wide_hills(100, {.eye_height_m = 500});
  const std::vector<Ray> rays = sun_rays(terrain, 0.35);
  TraceCounts single;
  for (const Ray& ray : rays) static_cast<void>(terrain.occluded(ray, &single));
  TraceCounts counts;
  std::vector<std::uint8_t> stopped(rays.size());
  occluded(terrain, rays, stopped, counts);
  EXPECT_LT(counts.tests + counts.nodes, 1.2 * static_cast<double>(single.tests + single.nodes));
}

}  // namespace
}  // namespace terrview

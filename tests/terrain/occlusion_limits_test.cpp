// Rays at the limits of single precision: terrain/occlusion.h.
#include "terrain/occlusion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "tests/support/judge.h"
#include "tests/support/random_scene.h"
#include "tests/support/scenes.h"

namespace terrview {
namespace {

// How many of them are stopped.
int expect_answers_of_single_rays(const Terrain& terrain, const std::vector<Ray>& rays) {
  std::vector<std::uint8_t> stopped(rays.size());
  TraceCounts counts;
  occluded(terrain, rays, stopped, counts);
  int count = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const bool expected = terrain.occluded(rays[i]);
    EXPECT_EQ(stopped[i] != 0, expected) << oracle::to_string(rays[i]);
    count += expected ? 1 : 0;
  }
  return count;
}

TEST(OccludedAtTheLimits, AnswersAsSingleRaysThatAreNearlyUpright) {
  const auto height_m = [](int column, int row) {
    return 300 + 100 * (std::sin(column * 0.07) + std::cos(row * 0.05 + 0.02 * column));
  };
  Random random(15);
  for (const double curvature_per_m : {0.0, 1 / 6.37e6}) {
    const Terrain terrain(
        {make_layer(make_grid(300, 300, height_m), {.eye_uv = {60, 150}, .spacing_m = {30, 30}})},
        {.eye_height_m = 500,
         .north_curvature_per_m = curvature_per_m,
         .east_curvature_per_m = curvature_per_m},
        SurfaceModel::hyperboloid);
    std::vector<Ray> rays;
    while (rays.size() < 10000) {
      const glm::dvec2 at_m(random.uniform(-1500, 7000), random.uniform(-4000, 4000));
      const auto hit = terrain.first_hit({.origin_m = {at_m, 10000}, .direction = {0, 0, -1}});
      if (!hit) continue;
      const double azimuth_rad = random.uniform(0, 6.3);
      const double aside = random.log_uniform(1e-15, 1e-3);
      const glm::dvec3 off_m(0, 0, random.sign() * random.log_uniform(1e-9, 1e4));
      rays.push_back({.origin_m = hit->position_m + off_m,
                      .direction = {aside * std::sin(azimuth_rad), aside * std::cos(azimuth_rad),
                                    random.sign()}});
    }
    const int stopped = expect_answers_of_single_rays(terrain, rays);
    EXPECT_GT(stopped, 2000);
    EXPECT_LT(stopped, 8000);
  }
}

// High over a plain and then at a wall, nearly along the outermost line of posts: nearer to it than
// single precision tells.
TEST(OccludedAtTheLimits, AnswersAsTheyDoAlongTheBordersOfTheGrid) {
  constexpr int kLast = 300;
  constexpr double kPost_m = 30;
  Random random(16);
  int stopped = 0;
  for (const bool transposed : {false, true}) {
    const auto height_m = [&](int column, int row) {
      return (transposed ? row : column) == kLast - 3 ? 600.0 : 0.0;
    };
    const Terrain terrain(
        {make_layer(make_grid(kLast + 1, kLast + 1, height_m), {.spacing_m = {kPost_m, kPost_m}})},
        {.eye_height_m = 0}, SurfaceModel::hyperboloid);
    std::vector<Ray> rays(5000);
    for (Ray& ray : rays) {
      const double inside = random.log_uniform(1e-12, 1e-3);
      const double aside = random.chance(0.3) ? 0 : random.sign() * random.log_uniform(1e-14, 1e-3);
      const double along = random.uniform(0, kLast - 30);
      const double border = random.chance(0.5) ? kLast - inside : inside;
      glm::dvec2 uv(along, border);
      glm::dvec2 towards(1, aside);
      if (transposed) {
        std::swap(uv.x, uv.y);
        std::swap(towards.x, towards.y);
      }
      ray.origin_m = {kPost_m * uv.x, -kPost_m * uv.y, random.log_uniform(1, 1000)};
      ray.direction = {towards.x, -towards.y, random.uniform(0, 0.1)};
    }
    stopped += expect_answers_of_single_rays(terrain, rays);
  }
  EXPECT_GT(stopped, 1000);
  EXPECT_LT(stopped, 9000);
}

}  // namespace
}  // namespace terrview

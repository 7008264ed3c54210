// Where rays come down to water, on a curved Earth: render/water.h.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

#include "render/water.h"
#include "tests/support/random_scene.h"
#include "tests/support/scenes.h"

namespace terrview {
namespace {

constexpr double kTurn = 6.283185307179586;

// Near enough the Earth, flattened.
VerticalFrame earth(double eye_height_m, double refraction) {
  return {.eye_height_m = eye_height_m,
          .north_curvature_per_m = 1 / 6370000.0,
          .east_curvature_per_m = 1 / 6388000.0,
          .refraction = refraction};
}

Ray ray_down(double azimuth_rad, double dip) {
  return {.direction = {3 * std::sin(azimuth_rad), 3 * std::cos(azimuth_rad), -3 * dip}};
}

double height_m(const VerticalFrame& frame, const Ray& ray, double along_m) {
  const glm::dvec3 point = ray.origin_m + along_m * glm::normalize(ray.direction);
  return frame.at(glm::dvec2(point)).scene_height_m(point.z);
}

// The least height of a ray to `end_m`, by golden sections: its height is convex.
double lowest_m(const VerticalFrame& frame, const Ray& ray, double end_m) {
  double from_m = 0;
  double to_m = end_m;
  for (int i = 0; i < 100; ++i) {
    const double a_m = from_m + 0.382 * (to_m - from_m);
    const double b_m = to_m - 0.382 * (to_m - from_m);
    (height_m(frame, ray, a_m) < height_m(frame, ray, b_m) ? to_m : from_m) =
        height_m(frame, ray, a_m) < height_m(frame, ray, b_m) ? b_m : a_m;
  }
  return std::min(height_m(frame, ray, from_m), height_m(frame, ray, end_m));
}

// The dip of the ray that touches the level 0.
double dip_of_horizon(const VerticalFrame& frame, double azimuth_rad, double end_m) {
  double above = 0;
  double below = 1;
  for (int i = 0; i < 60; ++i) {
    const double dip = 0.5 * (above + below);
    (lowest_m(frame, ray_down(azimuth_rad, dip), end_m) > 0 ? above : below) = dip;
  }
  return above;
}

// Steep rays, and rays about the horizon that dip under the water by some micrometres and more.
TEST(WaterLevel, IsMetByEveryRayThatDipsUnderIt) {
  constexpr double kClose_m = 1e-6;
  Random random(3);
  int met = 0;
  int missed = 0;
  for (int i = 0; i < 400; ++i) {
    const VerticalFrame frame = earth(random.log_uniform(2, 3000), random.uniform(0, 0.3));
    const double azimuth_rad = random.uniform(0, kTurn);
    const double end_m = random.uniform(100'000, 400'000);
    const double horizon = dip_of_horizon(frame, azimuth_rad, end_m);
    const double dip = random.chance(0.2)
                           ? random.log_uniform(0.001, 1)
                           : horizon * (1 + random.sign() * random.log_uniform(1e-8, 1e-2));
    const Ray ray = ray_down(azimuth_rad, dip);
    const double least_m = lowest_m(frame, ray, end_m);
    if (std::abs(least_m) < kClose_m) continue;
    const auto along_m = descent_m(frame, ray, 0, end_m);
    ASSERT_EQ(along_m.has_value(), least_m < 0) << least_m << ", end " << end_m;
    ++(along_m ? met : missed);
    if (!along_m) continue;
    EXPECT_NEAR(height_m(frame, ray, *along_m), 0, 1e-5);
    for (const double before : {0.1, 0.5, 0.9, 0.999})
      EXPECT_GT(height_m(frame, ray, before * *along_m), 0);
  }
  EXPECT_GT(met, 100);
  EXPECT_GT(missed, 100);
}

// A deep basin 27 km around the eye, between hills. From 20 m above its water the horizon is
// nearer than its northern shore.
constexpr double kLevel_m = 200;

Scene wide_basin() {
  const auto ground_m = [](int column, int row) {
    const double away = std::hypot(column - 60.0, row - 100.0);
    if (away < 45) return -5000.0;
    return 150 + 14 * (away - 44) + 60 * std::sin(column * 0.5) * std::cos(row * 0.4);
  };
  const TerrainLayer layer =
      make_layer(make_grid(121, 121, ground_m), {.eye_uv = {60.3, 100.2}, .spacing_m = {600, 600}});
  Scene scene;
  scene.terrain = std::make_shared<const Terrain>(std::vector{layer}, earth(kLevel_m + 20, 0.13),
                                                  SurfaceModel::hyperboloid);
  scene.water = std::make_shared<const Water>(Water{.level_m = kLevel_m});
  return scene;
}

// The first of close samples of a ray that is under water before it is under ground, as distance;
// nullopt where there is none.
std::optional<double> under_water_m(const Scene& scene, const Ray& ray, double step_m) {
  const VerticalFrame& frame = scene.terrain->frame();
  for (double along_m = step_m;; along_m += step_m) {
    const glm::dvec3 point = along_m * glm::normalize(ray.direction);
    const auto ground = scene.terrain->ground_at(glm::dvec2(point));
    if (!ground) return std::nullopt;
    const double height_m = frame.at(glm::dvec2(point)).scene_height_m(point.z);
    if (height_m < kLevel_m && ground->scene_height_m < kLevel_m) return along_m;
    if (height_m < ground->scene_height_m) return std::nullopt;
  }
}

TEST(WaterLevel, IsSeenWhereSamplesOfARayAreUnderIt) {
  constexpr double kStep_m = 20;
  const Scene scene = wide_basin();
  Random random(4);
  int wet = 0;
  int dry = 0;
  int behind_the_bulge = 0;
  for (int i = 0; i < 1000; ++i) {
    const Ray ray = ray_down(random.uniform(0, kTurn), random.uniform(-0.001, 0.005));
    const auto bed = scene.terrain->first_hit(ray);
    RayHits hits{{bed}};
    meet_water(scene, {&ray, 1}, hits);
    const auto expected_m = under_water_m(scene, ray, kStep_m);
    if (hits.meets_water(0) && !expected_m) {  // under water between two samples
      const double along_m = hits.ground[0]->distance_m;
      const double later_m = kStep_m * std::ceil(along_m / kStep_m);
      EXPECT_GT(height_m(scene.terrain->frame(), ray, later_m), kLevel_m - 0.1);
      continue;
    }
    ASSERT_EQ(hits.meets_water(0), expected_m.has_value()) << i;
    ++(expected_m ? wet : dry);
    if (!expected_m) continue;
    const double along_m = hits.ground[0]->distance_m;
    EXPECT_LE(along_m, *expected_m);
    EXPECT_GT(along_m, *expected_m - kStep_m);
    EXPECT_NEAR(height_m(scene.terrain->frame(), ray, along_m), kLevel_m, 1e-5);
    const bool dry_bed = bed && height_m(scene.terrain->frame(), ray, bed->distance_m) > kLevel_m;
    behind_the_bulge += dry_bed ? 1 : 0;
  }
  EXPECT_GT(wet, 300);
  EXPECT_GT(dry, 300);
  EXPECT_GT(behind_the_bulge, 20);
}

}  // namespace
}  // namespace terrview

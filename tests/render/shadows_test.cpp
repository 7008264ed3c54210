// Shadows of a sun that is a disc: render/shadows.h.
#include "render/shadows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>

#include "terrain/sun_map.h"
#include "terrain/view_transform.h"
#include "tests/support/scenes.h"

namespace terrview {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kRadians = kPi / 180;
constexpr double kTolerance = 0.03;

glm::dvec3 sun_at(double azimuth_deg, double elevation_deg) {
  const double run = std::cos(elevation_deg * kRadians);
  return {run * std::sin(azimuth_deg * kRadians), run * std::cos(azimuth_deg * kRadians),
          std::sin(elevation_deg * kRadians)};
}

Light soft_light(const glm::dvec3& towards_sun) {
  Light light;
  light.towards_sun = towards_sun;
  light.sun_radius_rad = kSunRadius_rad;
  return light;
}

std::vector<Hit> points_below(const Terrain& terrain, const std::vector<glm::dvec2>& ground_m) {
  std::vector<Hit> points;
  for (const glm::dvec2& at : ground_m) {
    const auto hit = terrain.first_hit({{at, 3000}, {0, 0, -1}});
    if (hit) points.push_back(*hit);
  }
  return points;
}

// The plain twin: every point of a fine lattice over the disc.
double share_of_every_point(const Terrain& terrain, const Light& light, const Hit& hit) {
  constexpr int kSide = 60;
  const glm::dvec3 right = glm::normalize(glm::dvec3(light.towards_sun.y, -light.towards_sun.x, 0));
  const glm::dvec3 up = glm::cross(right, light.towards_sun);
  int all = 0;
  int seen = 0;
  for (int i = 0; i < kSide; ++i) {
    for (int j = 0; j < kSide; ++j) {
      const glm::dvec2 at = (2.0 * glm::dvec2(i, j) + 1.0) / static_cast<double>(kSide) - 1.0;
      if (glm::length(at) > 1) continue;
      ++all;
      const glm::dvec3 sun =
          glm::normalize(light.towards_sun + light.sun_radius_rad * (at.x * right + at.y * up));
      const glm::dvec3 direction = direction_at(terrain.frame(), hit.position_m, sun);
      seen += terrain.occluded(terrain.leave(hit, direction)) ? 0 : 1;
    }
  }
  return static_cast<double>(seen) / all;
}

// The share of a disc above a level line at `height` radii over its centre.
double segment(double height) {
  if (height >= 1) return 0;
  if (height <= -1) return 1;
  return (std::acos(height) - height * std::sqrt(1 - height * height)) / kPi;
}

TEST(SunShares, BehindALevelBrinkAreThoseOfADiscCutByALine) {
  // High ground of 100 m to the west of x = 0; the sun 10 degrees high in the west.
  const Place place{.eye_uv = {40, 20}, .spacing_m = {20, 20}, .eye_height_m = 500};
  const Terrain terrain =
      make_terrain(make_grid(121, 41, [](int column, int) { return column <= 40 ? 100.0 : 0.0; }),
                   place, SurfaceModel::triangles);
  const Light light = soft_light(sun_at(270, 10));
  std::vector<glm::dvec2> ground_m;
  for (double x = 530; x < 610; x += 1.7) ground_m.emplace_back(x, 3.1);
  const std::vector<Hit> points = points_below(terrain, ground_m);
  ASSERT_EQ(points.size(), ground_m.size());
  ShadowCounts counts;
  const std::vector<float> shares = sun_shares({terrain}, light, points, counts);
  int partly = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double horizon_rad = std::atan2(100, points[i].position_m.x);
    const double expected = segment((horizon_rad - 10 * kRadians) / kSunRadius_rad);
    EXPECT_NEAR(shares[i], expected, kTolerance) << points[i].position_m.x;
    partly += expected > 0.01 && expected < 0.99 ? 1 : 0;
  }
  EXPECT_GT(partly, 8);
}

TEST(SunShares, OverRoughGroundAreThoseOfEveryPointOfTheDisc) {
  const Place place{.eye_uv = {30, 25}, .spacing_m = {60, 90}, .eye_height_m = 2000};
  const Terrain terrain =
      make_terrain(make_grid(60, 50,
                             [](int column, int row) {
                               return 200 * std::sin(column * 0.7) * std::cos(row * 0.45) +
                                      30 * std::sin(column * 2.9 + row * 1.7);
                             }),
                   place, SurfaceModel::triangles);
  const Light light = soft_light(sun_at(205, 12));
  std::vector<glm::dvec2> ground_m;
  for (int i = 0; i < 1500; ++i)
    ground_m.emplace_back(std::fmod(i * 37.7, 2400) - 1200, std::fmod(i * 91.3, 3000) - 1500);
  const std::vector<Hit> points = points_below(terrain, ground_m);
  ShadowCounts counts;
  const std::vector<float> shares = sun_shares({terrain}, light, points, counts);
  int partly = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool is_partly = shares[i] > 0.02F && shares[i] < 0.98F;
    partly += is_partly ? 1 : 0;
    if (!is_partly && i % 50 != 0) continue;
    EXPECT_NEAR(shares[i], share_of_every_point(terrain, light, points[i]), kTolerance);
  }
  EXPECT_GT(partly, 5);
  EXPECT_LT(counts.rays, 12 * static_cast<std::int64_t>(points.size()));
}

// The plain twin of a map of the sun: a ray a point.
TEST(SunShares, AreTheSameWithAMapOfTheSun) {
  const Place place{.eye_uv = {80, 95}, .spacing_m = {60, 90}, .eye_height_m = 2000};
  const auto height_m = [](int column, int row) {
    return 300 * std::sin(column * 0.17) * std::cos(row * 0.15) +
           20 * std::sin(column * 0.9 + row * 0.7);
  };
  for (const double curvature : {0.0, 1 / 6.37e6}) {
    Scene scene;
    scene.terrain = std::make_shared<const Terrain>(
        std::vector{make_layer(make_grid(160, 150, height_m), place)},
        VerticalFrame{.eye_height_m = 2000,
                      .north_curvature_per_m = curvature,
                      .east_curvature_per_m = curvature},
        SurfaceModel::hyperboloid);
    scene.light.towards_sun = sun_at(205, 12);
    std::vector<glm::dvec2> ground_m;
    for (int i = 0; i < 4000; ++i)
      ground_m.emplace_back(std::fmod(i * 37.7, 9000) - 4500, std::fmod(i * 91.3, 9000) - 4500);
    std::vector<Hit> points = points_below(*scene.terrain, ground_m);
    const std::size_t on_ground = points.size();
    for (std::size_t i = 0; i < on_ground; i += 3) {  // of objects: only their positions count
      Hit above = points[(i + 1) % on_ground];
      above.grid = kOffGround;
      above.position_m = points[i].position_m + glm::dvec3(0, 0, 0.01 * static_cast<double>(i));
      points.push_back(above);
    }
    EXPECT_FALSE(with_sun_map(scene, 10, 1).sun_map);  // not worth its while
    const Scene mapped = with_sun_map(scene, 1000000, 1);
    ASSERT_TRUE(mapped.sun_map);
    ShadowCounts counts;
    const auto with = sun_shares(shadow_casters(mapped), scene.light, points, counts);
    ShadowCounts plain_counts;
    const auto without = sun_shares(shadow_casters(scene), scene.light, points, plain_counts);
    EXPECT_EQ(with, without);
    EXPECT_EQ(counts.rays, plain_counts.rays);
    const auto lit = std::count(without.begin(), without.end(), 1.0F);
    EXPECT_GT(lit, 1000);
    EXPECT_LT(lit, static_cast<std::ptrdiff_t>(points.size()) - 500);
    scene.light.sun_radius_rad = kSunRadius_rad;
    EXPECT_FALSE(with_sun_map(scene, 1000000, 1).sun_map);
  }
}

TEST(SunShares, OfASunWithoutWidthAreAllOrNothingForOneRayEach) {
  const Place place{.eye_uv = {10, 10}, .spacing_m = {20, 20}, .eye_height_m = 500};
  const Terrain terrain =
      make_terrain(make_grid(41, 21, [](int column, int) { return column == 5 ? 90.0 : 0.0; }),
                   place, SurfaceModel::triangles);
  Light light = soft_light(sun_at(270, 15));
  light.sun_radius_rad = 0;
  std::vector<glm::dvec2> ground_m;
  for (double x = -60; x < 500; x += 7) ground_m.emplace_back(x, 1.5);
  const std::vector<Hit> points = points_below(terrain, ground_m);
  ShadowCounts counts;
  const std::vector<float> shares = sun_shares({terrain}, light, points, counts);
  EXPECT_EQ(counts.rays, static_cast<std::int64_t>(points.size()));
  float sum = 0;
  for (const float share : shares) {
    EXPECT_TRUE(share == 0 || share == 1);
    sum += share;
  }
  EXPECT_GT(sum, 10);
  EXPECT_LT(sum, static_cast<float>(points.size()) - 10);
}

}  // namespace
}  // namespace terrview

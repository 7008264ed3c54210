// The air between: render/air.h and the air of render/scene.h.
#include "render/air.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "tests/render/hills.h"

namespace terrview {
namespace {

constexpr float kTolerance = 1e-5F;

void expect_color(const glm::vec3& color, const glm::vec3& expected) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(color[i], expected[i], kTolerance);
}

// A wall 100 m high, `away_m` north of an eye at half its height.
Scene wall(double away_m) {
  const Place place{.eye_uv = {10, 5}, .spacing_m = {100, away_m}, .eye_height_m = 50};
  Scene scene;
  scene.terrain = std::make_shared<Terrain>(
      make_terrain(make_grid(21, 9, [](int, int row) { return row <= 4 ? 100.0 : 0.0; }), place,
                   SurfaceModel::triangles));
  return scene;
}

Camera narrow(double heading_deg = 0) {
  return Camera({.heading_rad = heading_deg * kRadians, .fov_rad = 1e-6, .size_px = {1, 1}});
}

TEST(Air, LeavesABlackRidgeAtTheVisibilityTwoPercentOfItsContrast) {
  for (const double visibility_m : {3000.0, 30000.0}) {
    // The wall rises evenly over its cell: half-way up it is at half the distance.
    Scene scene = wall(2 * visibility_m);
    scene.tints = {.stops = {{0, {0, 0, 0}}}};
    scene.air.extinction_per_m = kExtinctionTimesVisibility / visibility_m;
    const Frame frame = render(scene, narrow(), {.keep_samples = true});
    ASSERT_NEAR(frame.samples.at(0, 0).position_m.y, visibility_m, 1e-3 * visibility_m);
    const glm::vec3 contrast = 1.0F - frame.image.at(0, 0) / scene.sky.horizon;
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(contrast[i], 0.02, 1e-3);
  }
}

TEST(Air, MixesByTheLawOfTheDistanceInEveryPixel) {
  Scene scene = hills_scene();
  scene.air.extinction_per_m = 2e-4;
  const Frame frame = render(scene, tilted_camera({48, 36}), {.keep_samples = true});
  scene.air.extinction_per_m = 0;
  const Image clear = render(scene, tilted_camera({48, 36})).image;
  int hits = 0;
  for (int row = 0; row < 36; ++row) {
    for (int column = 0; column < 48; ++column) {
      const PixelSample& sample = frame.samples.at(column, row);
      const float q = sample.transmission;
      expect_color(sample.clear, clear.at(column, row));
      expect_color(frame.image.at(column, row), sample.clear * q + sample.air * (1 - q));
      if (sample.object_id == PixelSample::kNothing) {
        EXPECT_EQ(q, 1);
        continue;
      }
      ++hits;
      EXPECT_NEAR(q, std::exp(-2e-4 * glm::length(sample.position_m)), 1e-6);
    }
  }
  EXPECT_GT(hits, 500);
}

TEST(Air, IsTheSkysAtTheHorizonSoThatFarRidgesMeltIntoIt) {
  Scene scene = wall(20000);
  scene.air.extinction_per_m = 1e-2;
  scene.sky.sunward = glm::vec3(1, 0.5F, 0.2F);
  scene.light.towards_sun = sun_at(20, 3);
  expect_color(render(scene, narrow()).image.at(0, 0),
               background_color(scene, glm::dvec3(0, 1, 0)));
}

TEST(Air, TakesAGivenColourEverywhereAndASecondTowardsTheSun) {
  Scene scene;
  scene.light.towards_sun = sun_at(90, 0);
  scene.sky.sunward = glm::vec3(1, 0, 0);
  scene.air.color = glm::vec3(0.1F, 0.2F, 0.3F);
  expect_color(air_color(scene, {1, 0, 0}), *scene.air.color);
  expect_color(air_color(scene, {-1, 0, 0}), *scene.air.color);
  scene.air.sunward = glm::vec3(0.9F, 0.8F, 0.7F);
  expect_color(air_color(scene, {1, 0, 0}), *scene.air.sunward);
  expect_color(air_color(scene, {-1, 0, 0}), *scene.air.color);
  scene.air.color.reset();
  expect_color(air_color(scene, {-1, 0, 0}), scene.sky.horizon);
}

TEST(Air, BelowTheHorizonIsTheBackground) {
  Scene scene;
  scene.air.color = glm::vec3(0.1F, 0.2F, 0.3F);
  expect_color(background_color(scene, glm::normalize(glm::dvec3(0, 1, -0.1))), *scene.air.color);
  expect_color(background_color(scene, {0, 1, 0}), scene.sky.horizon);
}

}  // namespace
}  // namespace terrview

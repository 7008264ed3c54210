// Promises of render/painted_sky.h, and of scenes that have one.
#include "render/painted_sky.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "render/air.h"
#include "render/image.h"
#include "render/parallel.h"
#include "sky/sun.h"

namespace terrview {
namespace {

constexpr double kRadians = std::numbers::pi / 180;

SkyOptions cloudy_sky() {
  SkyOptions sky;
  sky.clear.towards_sun = towards({250 * kRadians, 30 * kRadians});
  sky.clouds.emplace();
  sky.clouds->field.kind = FieldKind::smooth;
  sky.clouds->field.levels = {8, 8};
  sky.clouds->layer.height_m = 1500;
  sky.clouds->layer.cell_m = 3000;
  sky.clouds->layer.curvature_per_m = 0.87 / 6.371e6;
  sky.clouds->table = sky_table(0.5);
  return sky;
}

std::vector<Camera> cameras() {
  CameraOptions rolled{.heading_rad = 1, .pitch_rad = 0.6, .roll_rad = 0.4, .size_px = {150, 90}};
  CameraOptions panorama{.projection = Projection::cylindrical,
                         .heading_rad = 2,
                         .fov_rad = 2 * std::numbers::pi,
                         .size_px = {300, 80}};
  return {Camera(rolled), Camera(panorama)};
}

TEST(PaintedSky, ShowsEachPixelTheColourOfItsDirection) {
  for (const Camera& camera : cameras()) {
    const PaintedSky sky(cloudy_sky(), camera, false);
    const SkyCamera painted = painted_camera(camera);
    const SkyPainter painter(cloudy_sky(), painted);
    const glm::ivec2 size = camera.options().size_px;
    for (int row = 0; row < size.y; row += 7) {
      for (int column = 0; column < size.x; column += 9) {
        const glm::dvec3 direction =
            glm::normalize(camera.ray(glm::dvec2(column, row) + 0.5).direction);
        const glm::ivec2 pixel(glm::floor(painted.image_of(direction)));
        ASSERT_EQ(sky.color(direction), painter.color(pixel)) << column << ' ' << row;
        ASSERT_LT(
            glm::distance(glm::normalize(painted.direction(glm::dvec2(pixel) + 0.5)), direction),
            1e-12);
      }
    }
  }
}

TEST(PaintedSky, DoesNotDependOnWhoAsksFirst) {
  for (const Camera& camera : cameras()) {
    const glm::ivec2 size = camera.options().size_px;
    const auto painted = [&](int threads, bool backwards) {
      const PaintedSky sky(cloudy_sky(), camera, false);
      Image image(size.x, size.y);
      parallel_for(size.y, threads, [&](int index) {
        const int row = backwards ? size.y - 1 - index : index;
        for (int column = 0; column < size.x; ++column)
          image.at(column, row) =
              sky.color(glm::normalize(camera.ray(glm::dvec2(column, row) + 0.5).direction));
      });
      return image.pixels();
    };
    const auto one = painted(1, false);
    EXPECT_EQ(one, painted(4, false));
    EXPECT_EQ(one, painted(4, true));
  }
}

TEST(PaintedSky, KeepsToThePicturesEdge) {
  for (const Camera& camera : cameras()) {
    const PaintedSky sky(cloudy_sky(), camera, false);
    const glm::dvec2 size(camera.options().size_px);
    for (const glm::dvec2 corner :
         {glm::dvec2(0, 0), {size.x, 0.0}, {0.0, size.y}, {size.x, size.y}}) {
      const glm::vec3 color = sky.color(glm::normalize(camera.ray(corner).direction));
      EXPECT_TRUE(std::isfinite(color.r + color.g + color.b));
    }
  }
}

TEST(PaintedSky, OfAnOrthographicViewIsClear) {
  const Camera camera(
      {.projection = Projection::orthographic, .width_m = 1000, .size_px = {50, 50}});
  const PaintedSky sky(cloudy_sky(), camera, false);
  const glm::dvec3 direction = glm::normalize(glm::dvec3(0.2, 1, 0.1));
  EXPECT_EQ(sky.color(direction),
            SkyPainter(cloudy_sky(), sky_camera(camera)).clear_color(direction));
}

TEST(PaintedSky, TheAirHasItsColourAtTheHorizon) {
  Scene scene;
  const Camera camera = cameras()[0];
  scene.painted_sky = std::make_shared<const PaintedSky>(cloudy_sky(), camera, false);
  const SkyPainter painter(cloudy_sky(), sky_camera(camera));
  for (int azimuth = 0; azimuth < 360; azimuth += 20) {
    const glm::dvec3 level = towards({azimuth * kRadians, 0});
    EXPECT_LT(glm::distance(air_color(scene, level), painter.background(level)), 1e-3F);
    const glm::dvec3 down = towards({azimuth * kRadians, -0.2});
    EXPECT_LT(glm::distance(background_color(scene, down), painter.background(level)), 1e-3F);
  }
  scene.air.color = glm::vec3(1, 0, 0);
  EXPECT_EQ(air_color(scene, {0, 1, 0}), glm::vec3(1, 0, 0));
}

// A point's shadow is the cloud that hides the sun from it.
TEST(CloudShadows, FallWhereCloudsHideTheSun) {
  const SkyOptions sky = cloudy_sky();
  const CloudShadows shadows(*sky.clouds, sky.clear.towards_sun);
  CameraOptions to_sun{.heading_rad = 250 * kRadians,
                       .pitch_rad = 30 * kRadians,
                       .fov_rad = 1 * kRadians,
                       .size_px = {9, 9}};
  int dark = 0;
  int light = 0;
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 point_m(i * 271.0, i * 97.0, 0);
    // The same clouds from an eye at that point.
    CloudLayer layer = sky.clouds->layer;
    layer.origin_m += glm::dvec2(point_m);
    layer.curvature_per_m = 0;
    layer.height_m -=
        sky.clouds->layer.curvature_per_m / 2 * (point_m.x * point_m.x + point_m.y * point_m.y);
    const RandomField field(sky.clouds->field);
    const CloudPainter painter(field, layer, sky_camera(Camera(to_sun)), 8);
    const TableWindow& window = sky.clouds->table.window;
    const double address = window.middle + window.width *
                                               static_cast<double>(painter.value({4, 4}).value) /
                                               field.expected_deviation();
    const double cover = sky.clouds->table.cover(address);
    const float share = shadows.share(point_m);
    EXPECT_GE(share, CloudShadows::kDarkest);
    EXPECT_LE(share, 1);
    if (address < sky.clouds->table.clear_until - 0.05) {
      EXPECT_GT(share, 0.95F) << i;
      ++light;
    }
    if (address > sky.clouds->table.cloud_from + 0.05) {
      EXPECT_LT(share, CloudShadows::kDarkest + 0.05F) << i;
      ++dark;
    }
    EXPECT_NEAR(share, 1 - (1 - static_cast<double>(CloudShadows::kDarkest)) * cover, 0.25) << i;
  }
  EXPECT_GT(dark, 20);
  EXPECT_GT(light, 20);
}

TEST(CloudShadows, NoneFallAboveTheClouds) {
  const SkyOptions sky = cloudy_sky();
  const CloudShadows shadows(*sky.clouds, sky.clear.towards_sun);
  for (int i = 0; i < 50; ++i) EXPECT_EQ(shadows.share({i * 300.0, 0, 1600}), 1);
}

}  // namespace
}  // namespace terrview

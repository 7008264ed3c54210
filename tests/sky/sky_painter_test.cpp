// Promises of sky/sky_painter.h.
#include "sky/sky_painter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "sky/sun.h"

namespace terrview {
namespace {

constexpr double kRadians = std::numbers::pi / 180;

SkyCamera camera_of(double pitch_deg, glm::ivec2 size_px = {160, 120}) {
  const double pitch = pitch_deg * kRadians;
  SkyCamera camera;
  camera.size_px = size_px;
  camera.middle_px = glm::dvec2(size_px) / 2.0;
  camera.focal_px = size_px.x / 2.0 / std::tan(25 * kRadians);
  camera.forward = {0, std::cos(pitch), std::sin(pitch)};
  camera.up = {0, -std::sin(pitch), std::cos(pitch)};
  return camera;
}

SkyOptions options_of(double clouds, double sun_elevation_deg = 30) {
  SkyOptions options;
  options.clear.towards_sun = towards({0, sun_elevation_deg * kRadians});
  options.clouds.emplace();
  options.clouds->field.kind = FieldKind::smooth;
  options.clouds->field.levels = {8, 8};
  options.clouds->field.h = {0.6};
  options.clouds->layer.curvature_per_m = 0.87 / 6.371e6;
  options.clouds->layer.cell_m = 2500;
  options.clouds->table = sky_table(clouds);
  return options;
}

// Nothing but the air, the sun and its halo.
SkyOptions cloudless(double sun_elevation_deg = 30) {
  SkyOptions options = options_of(0, sun_elevation_deg);
  options.clouds.reset();
  return options;
}

// The light that `more` has beyond `less` at a pixel.
double added(const SkyPainter& more, const SkyPainter& less, glm::ivec2 px) {
  return static_cast<double>(more.color(px).g - less.color(px).g);
}

std::vector<glm::vec3> painted(const SkyPainter& painter, glm::ivec2 first, glm::ivec2 size) {
  PixelWindow window{first, size, {}};
  window.wanted.assign(static_cast<std::size_t>(size.x * size.y), true);
  return painter.paint(window);
}

double angle_to_sun(const SkyCamera& camera, const SkyOptions& options, glm::dvec2 px) {
  return std::acos(glm::dot(glm::normalize(camera.direction(px)), options.clear.towards_sun));
}

TEST(SkyPainter, PaintsWhatSinglePixelsShow) {
  const SkyCamera camera = camera_of(25);
  for (const double clouds : {0.0, 0.4, 1.0}) {
    const SkyPainter painter(options_of(clouds), camera);
    const auto window = painted(painter, {64, 30}, {64, 40});
    for (int row = 0; row < 40; row += 3)
      for (int column = 0; column < 64; column += 5)
        ASSERT_EQ(window[static_cast<std::size_t>(row * 64 + column)],
                  painter.color({64 + column, 30 + row}));
  }
}

TEST(SkyPainter, WithoutCloudsIsTheClearSkyAndTheSun) {
  SkyOptions options = cloudless();
  const SkyCamera camera = camera_of(25);
  const SkyPainter painter(options, camera);
  for (int row = 0; row < 120; row += 11) {
    const glm::vec3 color = painter.color({20, row});
    EXPECT_EQ(color, painter.clear_color(glm::normalize(camera.direction({20.5, row + 0.5}))));
  }
}

TEST(SkyPainter, TheSunIsAWhiteDiscOfItsWidth) {
  SkyOptions options = cloudless();
  options.halo = 0;
  const SkyCamera camera = camera_of(30, {1200, 200});
  const SkyPainter with_sun(options, camera);
  options.sun_radius_rad = 0;
  const SkyPainter without(options, camera);
  double area_px = 0;
  for (int row = 80; row < 120; ++row)
    for (int column = 580; column < 620; ++column)
      area_px += added(with_sun, without, {column, row});
  const double one = added(with_sun, without, {599, 99});
  const double radius_px = 0.004652 * camera.focal_px;
  EXPECT_NEAR(area_px / one, std::numbers::pi * radius_px * radius_px, 0.04 * area_px / one);
  const glm::vec3 middle = with_sun.color({599, 99});
  EXPECT_GT(std::min({middle.r, middle.g, middle.b}), 1);
}

TEST(SkyPainter, TheHaloFallsWithTheSquareOfTheDistance) {
  SkyOptions options = cloudless();
  options.sun_radius_rad = 0;
  const SkyCamera camera = camera_of(30, {1200, 100});
  const SkyPainter with_halo(options, camera);
  options.halo = 0;
  const SkyPainter without(options, camera);
  const auto halo = [&](int column) { return added(with_halo, without, {column, 50}); };
  const auto angle = [&](int column) {
    return angle_to_sun(camera, options, {column + 0.5, 50.5});
  };
  for (const int column : {900, 1000, 1150}) {
    const double expected = std::pow(angle(column) / angle(800), -2);
    EXPECT_NEAR(halo(column) / halo(800) / expected, 1, 0.12) << column;
  }
}

TEST(SkyPainter, TheSunAndItsHaloActOnlyWhereTheSkyIsClear) {
  const SkyCamera camera = camera_of(30);
  SkyOptions options = options_of(1);
  const auto sunny = painted(SkyPainter(options, camera), {64, 40}, {32, 32});
  options.halo = 0;
  options.sun_radius_rad = 0;
  EXPECT_EQ(sunny, painted(SkyPainter(options, camera), {64, 40}, {32, 32}));
  options = options_of(0);
  const auto clear = painted(SkyPainter(options, camera), {64, 40}, {32, 32});
  options.halo = 0;
  const auto dull = painted(SkyPainter(options, camera), {64, 40}, {32, 32});
  for (std::size_t k = 0; k < clear.size(); ++k) EXPECT_GT(clear[k].g, dull[k].g);
}

TEST(SkyPainter, ASetSunShowsNoDisc) {
  SkyOptions options = cloudless(-5);
  options.halo = 0;
  const SkyPainter painter(options, camera_of(-5));
  const glm::vec3 at_the_sun = painter.color({80, 60});
  const glm::vec3 beside = painter.color({100, 60});
  EXPECT_LT(glm::distance(at_the_sun, beside), 0.05F);
}

TEST(SkyPainter, CloudsAreLitFromTheSunsSide) {
  const SkyCamera camera = camera_of(40);
  SkyOptions options = options_of(0.5);
  options.clear.towards_sun = towards({90 * kRadians, 15 * kRadians});
  options.halo = 0;
  const SkyPainter from_east(options, camera);
  options.clear.towards_sun = towards({-90 * kRadians, 15 * kRadians});
  const SkyPainter from_west(options, camera);
  const RandomField field(options.clouds->field);
  const CloudPainter values(field, options.clouds->layer, camera);
  // Where the field falls to the east, the eastern sun shows more light.
  double agreement = 0;
  int count = 0;
  for (int row = 10; row < 110; row += 2) {
    for (int column = 10; column < 150; column += 3) {
      const float here = values.value({column, row}).value;
      const float east = values.value({column + 5, row}).value;
      const float west = values.value({column - 5, row}).value;
      if (here / field.expected_deviation() < 0.5) continue;
      const float difference = from_east.color({column, row}).g - from_west.color({column, row}).g;
      agreement += (west - east > 0) == (difference > 0) ? 1 : 0;
      ++count;
    }
  }
  ASSERT_GT(count, 50);
  EXPECT_GT(agreement / count, 0.7);
}

TEST(SkyPainter, TheBackgroundGreysUnderClouds) {
  const SkyCamera camera = camera_of(20);
  const auto saturation = [&](double clouds) {
    const glm::vec3 color = SkyPainter(options_of(clouds), camera).background({0, -1, 0});
    return std::max({color.r, color.g, color.b}) / std::min({color.r, color.g, color.b}) - 1;
  };
  EXPECT_LT(saturation(1), 0.4F * saturation(0));
  EXPECT_GT(saturation(0.3), 0.8F * saturation(0));
}

TEST(SkyPainter, FarCloudsMeltIntoTheSkyBehindThem) {
  const SkyCamera camera = camera_of(2);
  SkyOptions options = options_of(0.6);
  options.halo = 0;
  const SkyPainter cloudy(options, camera);
  options.sun_radius_rad = 0;
  const auto mean_difference = [&](int row) {
    double sum = 0;
    for (int column = 0; column < 160; ++column)
      sum += static_cast<double>(glm::distance(
          cloudy.color({column, row}),
          cloudy.background(glm::normalize(camera.direction({column + 0.5, row + 0.5})))));
    return sum / 160;
  };
  EXPECT_LT(mean_difference(66), 0.1 * mean_difference(5));
}

}  // namespace
}  // namespace terrview

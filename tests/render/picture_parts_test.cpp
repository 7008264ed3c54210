// Promises of render/camera.h and render/render.h on parts of pictures and views around one circle.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "render/painted_sky.h"
#include "render/pixel_lattice.h"
#include "sky/sun.h"
#include "tests/render/hills.h"

namespace terrview {
namespace {

constexpr double kPi = std::numbers::pi;

CameraOptions round_view(double heading_deg, double fov_deg, glm::ivec2 size_px) {
  return {.projection = Projection::cylindrical,
          .heading_rad = heading_deg * kRadians,
          .fov_rad = fov_deg * kRadians,
          .size_px = size_px};
}

std::vector<Camera> some_cameras() {
  const glm::ivec2 size_px(61, 43);
  const CameraOptions tilted{
      .heading_rad = 0.3, .pitch_rad = -0.2, .roll_rad = 0.1, .size_px = size_px};
  const CameraOptions shifted{.heading_rad = 0.3, .shift = {0.113, -0.371}, .size_px = size_px};
  const CameraOptions parallel{.projection = Projection::orthographic,
                               .pitch_rad = -0.5,
                               .width_m = 9000,
                               .size_px = size_px};
  CameraOptions risen = round_view(20, 90, size_px);
  risen.shift.y = 0.2;
  return {Camera(tilted),
          Camera(shifted),
          Camera(parallel),
          Camera(risen),
          Camera(round_view(200, 50, size_px)),
          Camera(round_view(77.7, 360, {96, 30}))};
}

bool same_ray(const Ray& a, const Ray& b) {
  return a.origin_m == b.origin_m && a.direction == b.direction;
}

TEST(CameraPart, HasTheRaysOfTheWholeBitForBit) {
  const PixelRect rect{{7, 11}, {20, 9}};
  for (const Camera& camera : some_cameras()) {
    const Camera part = camera.part(rect);
    const Camera nested = camera.part({{4, 1}, {40, 20}}).part({{3, 10}, {20, 9}});
    EXPECT_EQ(part.options().size_px, rect.size_px);
    for (const glm::dvec2 point : {glm::dvec2(0.5, 0.5), {3.53125, 8.46875}, {19.5, 0.1875}}) {
      const Ray whole = camera.ray(point + glm::dvec2(rect.first_px));
      EXPECT_TRUE(same_ray(part.ray(point), whole));
      EXPECT_TRUE(same_ray(nested.ray(point), whole));
      const auto place = part.project(whole.origin_m + 1e3 * whole.direction);
      ASSERT_TRUE(place);
      EXPECT_LT(glm::distance(*place, point), 1e-7);
    }
  }
}

TEST(CameraPart, KeepsItsColumnsUpright) {
  for (const Camera& camera : some_cameras()) {
    const bool upright = column_view(camera).has_value();
    EXPECT_EQ(upright,
              camera.forward().z == 0 && camera.options().projection != Projection::orthographic);
    EXPECT_EQ(column_view(camera.part({{5, 5}, {9, 9}})).has_value(), upright);
  }
}

// Four sheets, three, and parts that begin anywhere, of odd widths and of even.
TEST(CylindricalCamera, SharesTheRaysOfOneCircle) {
  for (const int quarter_px : {75, 96, 301}) {
    for (const double heading_deg : {0.0, 37.123, 359.9}) {
      const Camera whole(round_view(heading_deg, 360, {4 * quarter_px, 10}));
      ASSERT_EQ(whole.circle_px(), 4 * quarter_px);
      for (const double turn_deg : {-135.0, -45.0, 45.0, 135.0, 225.0, 1665.0}) {
        const Camera sheet(round_view(heading_deg + turn_deg, 90, {quarter_px, 10}));
        const int first = static_cast<int>(std::lround((turn_deg + 135) / 90)) * quarter_px;
        for (int column = 0; column < quarter_px; ++column)
          ASSERT_TRUE(same_ray(sheet.ray({column + 0.5, 3.5}),
                               whole.ray({(first + column) % (4 * quarter_px) + 0.5, 3.5})));
      }
    }
  }
}

TEST(CylindricalCamera, ClosesAWholeTurnExactly) {
  const Camera camera(round_view(123.4, 360, {97, 30}));
  for (const double column : {-1.5, 0.5, 42.0, 96.5}) {
    EXPECT_TRUE(same_ray(camera.ray({column, 5}), camera.ray({column + 97, 5})));
    const double azimuth = (123.4 + (column - 48.5) * 360 / 97) * kRadians;
    const glm::dvec3 direction = camera.ray({column, 5}).direction;
    EXPECT_NEAR(std::remainder(std::atan2(direction.x, direction.y) - azimuth, 2 * kPi), 0,
                1e-6 * 2 * kPi / 97);
  }
}

// Everything that looks at neighbours or at the whole picture.
Scene busy_scene(const Camera& camera, double haze_px_per_m) {
  Scene scene = hills_scene();
  scene.contours.interval_m = 40;
  scene.light.sun_radius_rad = 0.005;
  scene.air = {.extinction_per_m = 3e-5, .haze_px_per_m = haze_px_per_m};
  SkyOptions sky;
  sky.clear.towards_sun = scene.light.towards_sun;
  sky.clouds.emplace();
  sky.clouds->field.kind = FieldKind::smooth;
  sky.clouds->field.levels = {8, 8};
  sky.clouds->layer.cell_m = 3000;
  sky.clouds->table = sky_table(0.5);
  scene.painted_sky = std::make_shared<const PaintedSky>(sky, camera, true);
  return scene;
}

struct Work {
  const char* name;
  int samples;
  bool preview;
  double haze_px_per_m;
};

class EveryWork : public testing::TestWithParam<Work> {
 protected:
  static Frame frame_of(const Camera& camera) {
    const Work& work = GetParam();
    return render(
        busy_scene(camera, work.haze_px_per_m), camera,
        {.keep_samples = !work.preview, .samples = work.samples, .preview = work.preview});
  }
};

// Parts that begin inside a block of 8 and at its first pixel.
TEST_P(EveryWork, MakesAPartAsItMakesTheWhole) {
  for (const Camera& camera : some_cameras()) {
    const Frame whole = frame_of(camera);
    for (const PixelRect& rect : {PixelRect{{7, 5}, {23, 18}}, PixelRect{{24, 16}, {16, 8}}}) {
      const Frame part = frame_of(camera.part(rect));
      for (int row = 0; row < rect.size_px.y; ++row) {
        for (int column = 0; column < rect.size_px.x; ++column) {
          const glm::ivec2 in_whole = rect.first_px + glm::ivec2(column, row);
          ASSERT_EQ(part.image.at(column, row), whole.image.at(in_whole.x, in_whole.y));
          if (part.samples.empty()) continue;
          ASSERT_EQ(part.samples.at(column, row).position_m,
                    whole.samples.at(in_whole.x, in_whole.y).position_m);
        }
      }
    }
  }
}

TEST_P(EveryWork, JoinsFourSheetsToTheWholeCircle) {
  constexpr int kSheet_px = 34;
  const Frame whole = frame_of(Camera(round_view(135, 360, {4 * kSheet_px, 30})));
  for (int sheet = 0; sheet < 4; ++sheet) {
    const Frame part = frame_of(Camera(round_view(90 * sheet, 90, {kSheet_px, 30})));
    for (int row = 0; row < 30; ++row) {
      for (int column = 0; column < kSheet_px; ++column)
        ASSERT_EQ(part.image.at(column, row), whole.image.at(sheet * kSheet_px + column, row));
    }
  }
}

// 136 pixels to the circle are blocks of 8.
INSTANTIATE_TEST_SUITE_P(Picture, EveryWork,
                         testing::Values(Work{"single", 1, false, 0}, Work{"adaptive", 0, false, 0},
                                         Work{"hazy", 0, false, 1e-3},
                                         Work{"supersampled", 3, false, 3e-4},
                                         Work{"preview", 1, true, 0}),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace terrview

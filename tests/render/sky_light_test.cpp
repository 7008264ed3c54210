// Sky light that follows the relief: render/sky_light.h.
#include "render/sky_light.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/render/hills.h"

namespace terrview {
namespace {

TEST(SkyLight, IsTheSameForAnyNumberOfThreads) {
  const Scene scene = hills_scene();
  const auto one = sky_views(*scene.terrain, {.azimuths = 16, .threads = 1});
  const auto many = sky_views(*scene.terrain, {.azimuths = 16, .threads = 5});
  ASSERT_EQ(one.size(), 1U);
  EXPECT_EQ(one.front().shares, many.front().shares);
}

TEST(SkyLight, DimsTheAmbientLightOfValleysAndNotOfPlains) {
  Scene scene;
  scene.terrain = std::make_shared<Terrain>(make_terrain(
      make_grid(81, 161, [](int column, int) { return column > 36 && column < 44 ? 0.0 : 800.0; }),
      Place{.eye_uv = {40, 80}, .spacing_m = {100, 100}, .eye_height_m = 3000},
      SurfaceModel::hyperboloid));
  scene.tints = {.stops = {{0, {1, 1, 1}}}};
  scene.light = {.towards_sun = {0, 0, -1}, .ambient = {0.4F, 0.4F, 0.4F}};
  scene.sky_views =
      std::make_shared<const std::vector<SkyView>>(sky_views(*scene.terrain, {.azimuths = 32}));
  const Camera down({.projection = Projection::orthographic,
                     .pitch_rad = -90 * kRadians,
                     .width_m = 7000,
                     .size_px = {71, 3}});
  const Image image = render(scene, down).image;
  // The middle of an endless gorge 800 m wide and as deep sees sin(atan(400 / 800)) of the sky.
  EXPECT_NEAR(image.at(35, 1).x / 0.4, 0.4472, 0.03);
  EXPECT_NEAR(image.at(5, 1).x / 0.4, 1, 0.01);
}

TEST(SkyLight, EndsWithWhatItsProgressThrows) {
  const Scene scene = hills_scene();
  EXPECT_THROW(static_cast<void>(sky_views(*scene.terrain, {.progress =
                                                                [](double share) {
                                                                  if (share > 0.5)
                                                                    throw std::domain_error("stop");
                                                                }})),
               std::domain_error);
}

}  // namespace
}  // namespace terrview

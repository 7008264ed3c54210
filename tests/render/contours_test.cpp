// Contour lines: render/contours.h.
#include "render/contours.h"

#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "tests/render/hills.h"

namespace terrview {
namespace {

TEST(ContourShare, OfARowOfPixelsIsALineAPixelWideWhereverItLies) {
  for (const double offset_m : {0.0, 0.3, 1.7, 4.9, 9.99}) {
    double sum = 0;
    for (int pixel = 0; pixel < 100; ++pixel) sum += contour_share(offset_m + pixel, 1, 10);
    EXPECT_NEAR(sum, 10, 1e-9) << offset_m;
  }
}

TEST(ContourShare, IsWholeAtTheLineAndNothingAPixelBeside) {
  EXPECT_EQ(contour_share(-300, 0.5, 100), 1);
  EXPECT_NEAR(contour_share(1200.25, 0.5, 100), 0.5, 1e-12);
  EXPECT_EQ(contour_share(1200.5, 0.5, 100), 0);
  EXPECT_EQ(contour_share(1150, 0.5, 100), 0);
}

TEST(ContourShare, FadesWhereLinesCrowdAndIsNothingOnLevelGround) {
  EXPECT_EQ(contour_share(100, 25, 100), 1);
  EXPECT_NEAR(contour_share(100, 100 / 3.0, 100), 0.5, 1e-12);
  EXPECT_EQ(contour_share(100, 50, 100), 0);
  EXPECT_EQ(contour_share(100, 1e9, 100), 0);
  EXPECT_EQ(contour_share(100, 0, 100), 0);
}

TEST(RiseOver, IsTheSlopeTimesTheWayUpIt) {
  const glm::dvec3 normal = glm::normalize(glm::dvec3(-0.3, -0.4, 1));
  EXPECT_NEAR(rise_over(glm::dmat2(2), normal, 1), 1, 1e-12);
  EXPECT_NEAR(rise_over(glm::dmat2(2), normal, 2), 0.5, 1e-12);
  EXPECT_NEAR(rise_over(glm::dmat2(10, 0, 0, 0), normal, 1), 3, 1e-12);
  EXPECT_EQ(rise_over(glm::dmat2(2), {0, 0, 1}, 1), 0);
}

// A slope that rises by 30 m a post to the east, seen from straight above, black on white.
Image sloping_picture(double z_scale) {
  const Place place{
      .eye_uv = {60, 60}, .spacing_m = {100, 100}, .eye_height_m = 30000, .z_scale = z_scale};
  Scene scene;
  scene.terrain = std::make_shared<Terrain>(
      make_terrain(make_grid(121, 121, [](int column, int) { return 30.0 * (column - 60); }), place,
                   SurfaceModel::hyperboloid));
  scene.tints = {.stops = {{0, {1, 1, 1}}}};
  scene.light = {.towards_sun = {0, 0, 1}, .sun = {0, 0, 0}, .ambient = {1, 1, 1}};
  scene.contours = {.interval_m = 300, .color = {0, 0, 0}, .opacity = 1};
  return render(scene,
                Camera({.projection = Projection::orthographic,
                        .pitch_rad = -90 * kRadians,
                        .width_m = 4000,
                        .size_px = {80, 20}}),
                {.samples = 1})
      .image;
}

TEST(Contours, LieAtTheirHeightsToAPartOfAPixel) {
  // 50 m a pixel, so 15 m of height, and a line every 20 pixels from the middle.
  for (const double z_scale : {1.0, 3.0}) {
    const Image image = sloping_picture(z_scale);
    for (const int line : {20, 40, 60}) {
      double sum = 0;
      double moment = 0;
      for (int column = line - 5; column < line + 5; ++column) {
        const double dark = 1 - static_cast<double>(image.at(column, 10).r);
        sum += dark;
        moment += dark * (column + 0.5);
      }
      EXPECT_NEAR(sum, 1, 0.01) << line;
      EXPECT_NEAR(moment / sum, line, 0.01) << line;
    }
    EXPECT_EQ(image.at(30, 10).r, 1);
  }
}

}  // namespace
}  // namespace terrview

// The blur of what is far away: render/haze.h.
#include "render/haze.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/render/hills.h"

namespace terrview {
namespace {

constexpr double kBlur_px_per_m = 2.0 / 10000;  // two pixels at 10 km
constexpr glm::vec3 kRed(0.8F, 0.1F, 0.1F);
constexpr glm::vec3 kBlue(0.1F, 0.2F, 0.9F);

Air hazy() {
  Air air;
  air.haze_px_per_m = kBlur_px_per_m;
  return air;
}

Raster<Sample> even(float distance_m, const glm::vec3& color) {
  return Raster<Sample>(41, 41, {color, distance_m});
}

TEST(Haze, NeverBleedsAcrossAnOutlineFromNearToFarNorBack) {
  Raster<Sample> base = even(12000, kBlue);
  for (int row = 0; row < 41; ++row) {
    for (int column = 0; column < 20; ++column) base.at(column, row) = {kRed, 9000};
  }
  const Haze haze(hazy(), base);
  for (int row = 0; row < 41; row += 5) {
    for (int column = 0; column < 41; ++column) {
      const glm::vec3 color = haze.blurred({column, row}, base.at(column, row));
      const glm::vec3 expected = column < 20 ? kRed : kBlue;
      for (int i = 0; i < 3; ++i) EXPECT_NEAR(color[i], expected[i], 1e-6F) << column;
    }
  }
}

TEST(Haze, LeavesTheBackgroundAndWhatIsNearAsTheyAre) {
  Raster<Sample> base = even(500, kRed);
  base.at(20, 20) = {kBlue, 500};
  base.at(10, 10) = {kBlue, std::numeric_limits<float>::infinity()};
  const Haze haze(hazy(), base);
  EXPECT_EQ(haze.blurred({20, 20}, base.at(20, 20)), kBlue);
  EXPECT_EQ(haze.blurred({10, 10}, base.at(10, 10)), kBlue);
}

// The spread of a bright pixel, pixels, each axis.
double spread_px(float distance_m) {
  Raster<Sample> base = even(distance_m, glm::vec3(0));
  base.at(20, 20).color = glm::vec3(1);
  const Haze haze(hazy(), base);
  double sum = 0;
  double squares = 0;
  for (int row = 0; row < 41; ++row) {
    for (int column = 0; column < 41; ++column) {
      const double value = haze.blurred({column, row}, base.at(column, row)).x;
      sum += value;
      squares += value * (column - 20) * (column - 20);
    }
  }
  EXPECT_NEAR(sum, 1, 1e-3);
  return std::sqrt(squares / sum);
}

TEST(Haze, SpreadsAPixelInProportionToItsDistance) {
  // Cut off at two standard deviations, a Gaussian keeps 0.83 of its spread.
  EXPECT_NEAR(spread_px(10000), 0.83 * 2, 0.12);
  EXPECT_NEAR(spread_px(20000), 0.83 * 4, 0.2);
}

TEST(Haze, FillsOnlyBetweenGroundOfOneDistanceThatItBlurs) {
  Raster<Sample> base = even(10000, kRed);
  const Haze haze(hazy(), base);
  EXPECT_TRUE(haze.fills({11, 12}));
  EXPECT_TRUE(haze.fills({11, 11}));
  EXPECT_FALSE(haze.fills({12, 12}));  // itself one of the even
  base.at(12, 12).distance_m = 12000;
  EXPECT_FALSE(haze.fills({11, 12}));
  base.at(12, 12).distance_m = std::numeric_limits<float>::infinity();
  EXPECT_FALSE(haze.fills({11, 12}));
  base = even(4000, kRed);
  EXPECT_FALSE(haze.fills({11, 12}));
}

Scene hazy_hills(double haze_px_per_m) {
  Scene scene = hills_scene();
  scene.air.haze_px_per_m = haze_px_per_m;
  return scene;
}

TEST(Haze, SparesRaysFarAwayForNearlyTheSamePicture) {
  for (const bool level : {true, false}) {
    const Camera camera = level ? level_camera({400, 300}) : tilted_camera({400, 300});
    const Scene scene = hazy_hills(1.0 / 1200);
    const Frame full = render(scene, camera, {.sparse_haze = false});
    const Frame sparse = render(scene, camera);
    EXPECT_LT(static_cast<double>(sparse.counts.rays),
              0.85 * static_cast<double>(full.counts.rays));
    EXPECT_GT(psnr_db(sparse.image, full.image), 38);
  }
}

TEST(Haze, IsTheSamePictureWithLayersAsWithout) {
  const Scene scene = hazy_hills(1.0 / 3000);
  const Camera camera = tilted_camera({120, 90});
  EXPECT_EQ(render(scene, camera, {.keep_samples = true, .samples = 0}).image.pixels(),
            render(scene, camera, {.samples = 0}).image.pixels());
}

TEST(Haze, OffIsThePictureOfSharpAir) {
  const Camera camera = level_camera({60, 45});
  EXPECT_EQ(render(hazy_hills(1e-9), camera).image.pixels(),
            render(hazy_hills(0), camera).image.pixels());
}

}  // namespace
}  // namespace terrview

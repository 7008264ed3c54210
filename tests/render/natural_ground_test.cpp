// Colours by slope and altitude: render/natural_ground.h.
#include "render/natural_ground.h"

#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "tests/render/hills.h"

namespace terrview {
namespace {

constexpr NaturalGround kGround{.snow_line_m = 2500, .rock_slope_rad = 35 * kRadians};

glm::vec3 at(double height_m, double slope_deg) {
  return natural_color(kGround, height_m, slope_deg * kRadians);
}

bool is_green(const glm::vec3& color) { return color.g > color.r && color.g > 1.5F * color.b; }
bool is_grey(const glm::vec3& color) {
  return color.r < 0.3F && std::abs(color.g - color.r) < 0.05F &&
         std::abs(color.g - color.b) < 0.05F;
}
bool is_white(const glm::vec3& color) { return color.r > 0.8F && color.g > 0.8F && color.b > 0.8F; }

TEST(NaturalColor, IsGrassBelowSnowAboveAndRockWhereItIsSteep) {
  EXPECT_TRUE(is_green(at(300, 0)));
  EXPECT_TRUE(is_green(at(1400, 20)));
  EXPECT_TRUE(is_grey(at(300, 50)));
  EXPECT_TRUE(is_grey(at(4000, 60)));
  EXPECT_TRUE(is_white(at(3000, 0)));
  EXPECT_TRUE(is_white(at(8000, 30)));
}

TEST(NaturalColor, HasLessSnowTheSteeperItIs) {
  for (double slope = 0; slope < 80; slope += 1)
    EXPECT_LE(at(3500, slope + 1).r, at(3500, slope).r + 1e-6F) << slope;
  EXPECT_LT(at(3500, 48).r, 0.8F * at(3500, 30).r);
}

TEST(NaturalColor, HasHalfItsSnowAtTheSnowLine) {
  const float bare = at(2200, 0).b;
  const float white = at(2800, 0).b;
  EXPECT_NEAR(at(2500, 0).b, (bare + white) / 2, 0.01);
  NaturalGround higher = kGround;
  higher.snow_line_m += 1000;
  EXPECT_EQ(natural_color(higher, 3500, 0.2), natural_color(kGround, 2500, 0.2));
}

TEST(NaturalColor, HasNoSteps) {
  for (double height_m = -400; height_m < 5000; height_m += 1)
    for (const double slope : {0.0, 20.0, 35.0, 41.0, 50.0}) {
      EXPECT_LT(glm::distance(at(height_m, slope), at(height_m + 1, slope)), 0.005);
      const double steeper = height_m / 5000 * 89;
      EXPECT_LT(glm::distance(at(slope * 100, steeper), at(slope * 100, steeper + 0.05)), 0.02);
    }
}

TEST(NaturalColor, GoesByTheSlopeOfTheDemWhateverTheScale) {
  for (const double z_scale : {0.5, 1.0, 3.0}) {
    const glm::dvec3 normal = glm::normalize(glm::dvec3(-0.3 * z_scale, 0.4 * z_scale, 1));
    EXPECT_NEAR(slope_of(normal, z_scale), std::atan(0.5), 1e-12);
  }
}

// A staircase of steep faces, far away.
TEST(NaturalColor, DoesNotSparkleWherePixelsCoverManyPosts) {
  Scene scene =
      scene_over(make_grid(900, 900,
                           [](int column, int row) {
                             return 900 + 60 * std::sin(2.1 * column) * std::sin(1.7 * row);
                           }),
                 2500);
  scene.light = {.towards_sun = {0, 0, 1}, .sun = {0, 0, 0}, .ambient = {1, 1, 1}};
  scene.natural = kGround;
  const Camera camera({.pitch_rad = -3 * kRadians, .fov_rad = 0.5, .size_px = {80, 20}});
  const auto roughness = [&] {
    const Image image = render(scene, camera).image;
    double sum = 0;
    for (int row = 12; row < 20; ++row)
      for (int column = 1; column < 80; ++column)
        sum += static_cast<double>(glm::distance(image.at(column, row), image.at(column - 1, row)));
    return sum / (8 * 79);
  };
  const double sharp = roughness();
  scene.detail = std::make_shared<GroundDetail>(*scene.terrain);
  EXPECT_LT(roughness(), 0.5 * sharp);
}

}  // namespace
}  // namespace terrview

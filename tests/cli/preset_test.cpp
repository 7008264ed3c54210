// Pictures on paper: docs/panoramas.md.
#include "cli/preset.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "cli/view_setup.h"
#include "tests/cli/small_view.h"

namespace terrview {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

Camera camera_of(const std::string& preset, std::optional<double> dpi = {}) {
  ViewOptions options;
  options.preset = preset;
  options.dpi = dpi;
  apply_preset(options);
  return make_camera(known_view(options));
}

// The angle between two points of the picture, as shares of its width and height.
double angle_deg(const Camera& camera, glm::dvec2 from, glm::dvec2 to) {
  const glm::dvec2 size(camera.options().size_px);
  const glm::dvec3 a = glm::normalize(camera.ray(from * size).direction);
  const glm::dvec3 b = glm::normalize(camera.ray(to * size).direction);
  return std::acos(glm::dot(a, b)) * kDegrees;
}

struct Sheet {
  const char* preset;
  glm::ivec2 at_300_dpi;
  double across_deg;
  double down_deg;
  double distance_mm;  // from which its angles are right
  double width_mm;
};

class EveryPreset : public testing::TestWithParam<Sheet> {};

TEST_P(EveryPreset, HasItsFieldOfViewAtItsSizeOnPaper) {
  const Sheet& sheet = GetParam();
  const Camera camera = camera_of(sheet.preset);
  EXPECT_EQ(camera.options().size_px, sheet.at_300_dpi);
  EXPECT_NEAR(angle_deg(camera, {0, 0.5}, {1, 0.5}), sheet.across_deg, 0.005);
  // Heights are whole pixels.
  EXPECT_NEAR(angle_deg(camera, {0.5, 0}, {0.5, 1}), sheet.down_deg, 0.01);
  const double pixel_mm = sheet.width_mm / sheet.at_300_dpi.x;
  EXPECT_NEAR(pixel_mm / camera.per_px(), sheet.distance_mm, 0.5);
  EXPECT_NEAR(pixel_mm, 25.4 / 300, 1e-5);
}

TEST_P(EveryPreset, KeepsItsFieldOfViewAtOtherResolutions) {
  const Sheet& sheet = GetParam();
  const Camera camera = camera_of(sheet.preset, 30);
  EXPECT_NEAR(camera.options().size_px.x, sheet.at_300_dpi.x / 10.0, 0.5);
  EXPECT_NEAR(camera.options().size_px.y, sheet.at_300_dpi.y / 10.0, 0.5);
  EXPECT_NEAR(angle_deg(camera, {0, 0.5}, {1, 0.5}), sheet.across_deg, 0.005);
}

INSTANTIATE_TEST_SUITE_P(Preset, EveryPreset,
                         testing::Values(Sheet{"a1-planar", {9685, 3071}, 53.5, 18.16, 813.4, 820},
                                         Sheet{"a3-50mm", {4606, 3071}, 39.6, 26.99, 541.7, 390},
                                         Sheet{
                                             "baseline-90", {9685, 1535}, 90, 14.19, 522.0, 820}));

class PresetView : public SmallView {};

TEST_F(PresetView, RefusesASayInWhatThePresetSays) {
  for (const std::string other : {"--fov 50", "--size 64x48", "--projection perspective"})
    expect_refused(run(words("hills.tif --eye 48,7,900 --preset a3-50mm " + other)),
                   {"--preset a3-50mm", other.substr(0, other.find(' '))});
  expect_refused(run(words("hills.tif --eye 48,7,900 --dpi 0")), {"--dpi"});
}

TEST_F(PresetView, IsShownInStripsOfTheWhole) {
  const std::string line =
      "hills.tif -q --eye 48,7,900 --preset baseline-90 --dpi 6 --heading 90 --layers ";
  ASSERT_EQ(run(words(line + "a.tif -o a.png")).exit_code, 0);
  ASSERT_EQ(run(words(line + "b.tif --crop 100,7,94,20 -o b.png")).exit_code, 0);
  const Layers whole = layers("a.tif");
  const Layers part = layers("b.tif");
  ASSERT_EQ(whole.width_px, 194);
  ASSERT_EQ(part.width_px, 94);
  int hits = 0;
  for (int row = 0; row < 20; ++row) {
    for (int column = 0; column < 94; ++column) {
      const double distance_m = part.at("distance_m", column, row);
      if (std::isnan(distance_m)) continue;
      ++hits;
      ASSERT_EQ(distance_m, whole.at("distance_m", column + 100, row + 7));
    }
  }
  EXPECT_GT(hits, 500);
}

TEST_F(PresetView, RefusesACropBeyondThePicture) {
  for (const std::string crop :
       {"0,0,65,48", "0,1,64,48", "-1,0,9,9", "5,5,0,9", "1,2,3", "0,0,1.5,3"})
    expect_refused(run(words("hills.tif --eye 48,7,900 --size 64x48 --crop=" + crop)), {"--crop"});
}

}  // namespace
}  // namespace terrview

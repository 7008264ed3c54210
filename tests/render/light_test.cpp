// The light of render/scene.h against closed forms, and what render/render.h promises of a frame.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/render.h"
#include "tests/support/scenes.h"

namespace terrview {
namespace {

constexpr double kRadians = std::numbers::pi / 180;
constexpr glm::vec3 kGroundColor(0.8F, 0.5F, 0.25F);
constexpr float kTolerance = 1e-6F;

glm::dvec3 sun_at(double azimuth_deg, double elevation_deg) {
  const double run = std::cos(elevation_deg * kRadians);
  return {run * std::sin(azimuth_deg * kRadians), run * std::cos(azimuth_deg * kRadians),
          std::sin(elevation_deg * kRadians)};
}

// Ground of one colour under an eye 500 m above zero.
Scene scene_of(HeightGrid grid, const glm::dvec2& spacing_m, const glm::dvec3& towards_sun,
               SurfaceModel model = SurfaceModel::triangles) {
  const Place place{.eye_uv = glm::dvec2(grid.columns - 1, grid.rows - 1) / 2.0,
                    .spacing_m = spacing_m,
                    .eye_height_m = 500};
  Scene scene;
  scene.terrain = std::make_shared<Terrain>(make_terrain(std::move(grid), place, model));
  scene.tints = {.stops = {{0, kGroundColor}}};
  scene.light = {.towards_sun = towards_sun,
                 .sun = {0.9F, 0.7F, 0.4F},
                 .ambient = {0.1F, 0.2F, 0.3F},
                 .casts_shadows = true};
  return scene;
}

// Straight down, north up, a pixel `width_m` / `size_px.x` metres wide.
Camera map_camera(double width_m, glm::ivec2 size_px) {
  return Camera({.projection = Projection::orthographic,
                 .pitch_rad = -90 * kRadians,
                 .width_m = width_m,
                 .size_px = size_px});
}

// I = Ia ka + facing Is kd.
glm::vec3 lit(const Scene& scene, double facing) {
  return scene.light.ambient * kGroundColor +
         static_cast<float>(facing) * scene.light.sun * kGroundColor;
}

void expect_color(const glm::vec3& color, const glm::vec3& expected, const std::string& where) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(color[i], expected[i], kTolerance) << where;
}

void expect_every_pixel(const Image& image, const glm::vec3& expected) {
  for (const glm::vec3& pixel : image.pixels()) expect_color(pixel, expected, "everywhere");
}

HeightGrid plain() {
  return make_grid(12, 10, [](int, int) { return 0.0; });
}

TEST(Light, OfASunAt30DegreesGivesAPlainHalfTheSun) {
  for (const double azimuth_deg : {0.0, 77.0, 200.0}) {
    const Scene scene = scene_of(plain(), {60, 90}, sun_at(azimuth_deg, 30));
    expect_every_pixel(render(scene, map_camera(500, {20, 12})).image, lit(scene, 0.5));
  }
}

TEST(Light, IsTheAmbientAloneUnderASunBelowTheHorizon) {
  for (const double elevation_deg : {-0.01, -5.0, -90.0}) {
    const Scene scene = scene_of(plain(), {60, 90}, sun_at(120, elevation_deg));
    expect_every_pixel(render(scene, map_camera(500, {20, 12})).image, lit(scene, 0));
  }
}

TEST(Light, FollowsTheColourOfTheAltitudeWhateverItsExaggeration) {
  for (const double z_scale : {1.0, 3.0}) {
    const Place place{
        .eye_uv = {3.5, 3.5}, .spacing_m = {60, 60}, .eye_height_m = 2000, .z_scale = z_scale};
    Scene scene = scene_of(plain(), {60, 60}, {0, 0, 1});
    scene.terrain = std::make_shared<Terrain>(make_terrain(
        make_grid(8, 8, [](int, int) { return 250.0; }), place, SurfaceModel::triangles));
    scene.tints = {.stops = {{0, {0, 0, 0}}, {1000, {1, 1, 1}}}};
    const glm::vec3 expected = (scene.light.ambient + scene.light.sun) * 0.25F;
    const Image image = render(scene, map_camera(300, {10, 10})).image;
    for (const glm::vec3& pixel : image.pixels()) expect_color(pixel, expected, "at 250 m");
  }
}

// A cliff of 100 m, one cell of 10 m wide, along the meridian: high ground to the west.
constexpr double kCell_m = 10;
constexpr int kLastHighColumn = 20;

HeightGrid cliff() {
  return make_grid(121, 7, [](int column, int) { return column <= kLastHighColumn ? 100.0 : 0.0; });
}

// Where the cliff's brink is, east of the eye, which is over the grid's middle.
constexpr double kBrink_m = (kLastHighColumn - 60) * kCell_m;

class ShadowOfACliff : public testing::TestWithParam<SurfaceModel> {};

TEST_P(ShadowOfACliff, ReachesItsHeightOverTheTangentOfTheSunsElevation) {
  for (const double elevation_deg : {10.0, 25.0, 60.0}) {
    const Scene scene =
        scene_of(cliff(), {kCell_m, kCell_m}, sun_at(270, elevation_deg), GetParam());
    const Frame frame = render(scene, map_camera(1190, {595, 5}), {.keep_samples = true});
    const double end_m = kBrink_m + 100 / std::tan(elevation_deg * kRadians);
    int dark = 0;
    for (int column = 0; column < 595; ++column) {
      const double east_m = frame.samples.at(column, 2).position_m.x;
      if (east_m < kBrink_m + kCell_m) continue;  // above the brink, and the face
      const bool in_shadow = frame.image.at(column, 2) == scene.light.ambient * kGroundColor;
      dark += in_shadow ? 1 : 0;
      if (std::abs(east_m - end_m) < kCell_m) continue;
      EXPECT_EQ(in_shadow, east_m < end_m) << east_m << " of " << end_m;
    }
    EXPECT_GT(dark, 5);
  }
}

TEST_P(ShadowOfACliff, FallsNowhereUnderAHigherSunNorFromTheOtherSide) {
  for (const glm::dvec3& sun : {sun_at(270, 89), sun_at(90, 3)}) {
    const Scene scene = scene_of(cliff(), {kCell_m, kCell_m}, sun, GetParam());
    const Frame frame = render(scene, map_camera(1190, {595, 5}), {.keep_samples = true});
    for (int column = 0; column < 595; ++column) {
      const double east_m = frame.samples.at(column, 2).position_m.x;
      if (east_m < kBrink_m + 3 * kCell_m) continue;
      expect_color(frame.image.at(column, 2), lit(scene, sun.z), std::to_string(east_m));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(EverySurface, ShadowOfACliff, testing::ValuesIn(kSurfaceModels),
                         [](const auto& model) { return std::string(name_of(model.param)); });

TEST(Light, HasNoShadowWhereItCastsNone) {
  Scene scene = scene_of(cliff(), {kCell_m, kCell_m}, sun_at(270, 10));
  scene.light.casts_shadows = false;
  const Frame frame = render(scene, map_camera(1190, {119, 5}), {.keep_samples = true});
  for (int column = 0; column < 119; ++column) {
    if (frame.samples.at(column, 2).position_m.x > kBrink_m + 2 * kCell_m)
      expect_color(frame.image.at(column, 2), lit(scene, std::sin(10 * kRadians)), "on the plain");
  }
  EXPECT_EQ(frame.counts.shadow_rays, 0);
}

// A roof: a ridge along the meridian through the eye's foot, falling `kFall` metres a metre.
constexpr double kFall = 0.5;

HeightGrid roof() {
  return make_grid(21, 7,
                   [](int column, int) { return 100 - kFall * kCell_m * std::abs(column - 10); });
}

// N . L of the ground whose height changes by `slope` metres a metre eastwards.
double facing_of(double slope, const glm::dvec3& towards_sun) {
  return glm::dot(glm::normalize(glm::dvec3(-slope, 0, 1)), towards_sun);
}

TEST(Light, OfASunBelowTheHorizonReachesNoSlopeThatFacesIt) {
  Scene scene = scene_of(roof(), {kCell_m, kCell_m}, sun_at(270, -5));
  ASSERT_GT(facing_of(kFall, scene.light.towards_sun), 0.3);
  for (const bool casts_shadows : {true, false}) {
    scene.light.casts_shadows = casts_shadows;
    expect_every_pixel(render(scene, map_camera(180, {60, 4})).image, lit(scene, 0));
  }
}

TEST(FacetNormals, LightEachSideOfARoofEvenly) {
  Scene scene = scene_of(roof(), {kCell_m, kCell_m}, sun_at(270, 50));
  scene.normals = NormalKind::facet;
  const Frame frame = render(scene, map_camera(180, {60, 4}), {.keep_samples = true});
  for (int column = 0; column < 60; ++column) {
    const double east_m = frame.samples.at(column, 1).position_m.x;
    const double slope = east_m < 0 ? kFall : -kFall;
    expect_color(frame.image.at(column, 1), lit(scene, facing_of(slope, scene.light.towards_sun)),
                 std::to_string(east_m));
  }
}

TEST(SmoothNormals, TurnEvenlyAcrossARidge) {
  const Scene scene = scene_of(roof(), {kCell_m, kCell_m}, sun_at(270, 50));
  const Frame frame = render(scene, map_camera(180, {60, 4}), {.keep_samples = true});
  for (int column = 0; column < 60; ++column) {
    const double east_m = frame.samples.at(column, 1).position_m.x;
    // Central differences: level on the ridge, the full fall a cell away.
    const double slope = -kFall * glm::clamp(east_m / kCell_m, -1.0, 1.0);
    expect_color(frame.image.at(column, 1), lit(scene, facing_of(slope, scene.light.towards_sun)),
                 std::to_string(east_m));
  }
}

TEST(Background, IsTheHorizonsColourBelowTheHorizonAndBluerAbove) {
  // A small ground far below: from 500 m a level view sees past it.
  const Scene scene = scene_of(plain(), {1, 1}, {0, 0, 1});
  const Camera camera({.fov_rad = 60 * kRadians, .size_px = {9, 41}});
  const Image image = render(scene, camera).image;
  for (int row = 20; row < 41; ++row) EXPECT_EQ(image.at(4, row), scene.sky.horizon) << row;
  for (int row = 0; row < 20; ++row) {
    EXPECT_LT(image.at(4, row).x, image.at(4, row + 1).x) << row;
    EXPECT_GT(image.at(4, row).x, scene.sky.zenith.x) << row;
  }
  const Camera upwards({.pitch_rad = 90 * kRadians, .size_px = {1, 1}});
  expect_color(render(scene, upwards).image.at(0, 0), scene.sky.zenith, "overhead");
}

TEST(Background, HasNoEdgeAtTheHorizon) {
  const Scene scene = scene_of(plain(), {1, 1}, {0, 0, 1});
  // Rows a ten thousandth of a radian apart.
  const Camera camera({.heading_rad = 1, .fov_rad = 1e-4, .size_px = {1, 20}});
  const Image image = render(scene, camera).image;
  for (int row = 0; row < 19; ++row) {
    const glm::vec3 step = image.at(0, row) - image.at(0, row + 1);
    EXPECT_LT(glm::length(step), 4e-4) << row;
  }
}

TEST(Background, TakesTheSunwardColourTowardsTheSunAndNotBehind) {
  Scene scene = scene_of(plain(), {1, 1}, sun_at(90, 0));
  scene.sky.sunward = glm::vec3(1, 0.5F, 0);
  const auto towards = [&](double heading_deg) {
    const Camera camera({.heading_rad = heading_deg * kRadians, .size_px = {1, 1}});
    return render(scene, camera).image.at(0, 0);
  };
  expect_color(towards(90), *scene.sky.sunward, "towards the sun");
  expect_color(towards(270), scene.sky.horizon, "away from it");
  EXPECT_GT(towards(60).x, towards(30).x);
}

HeightGrid hills() {
  return make_grid(60, 50, [](int column, int row) {
    return 60 * std::sin(column * 0.7) * std::cos(row * 0.45) + 0.8 * column;
  });
}

Camera hills_camera() {
  return Camera({.heading_rad = 30 * kRadians,
                 .pitch_rad = -35 * kRadians,
                 .roll_rad = 5 * kRadians,
                 .size_px = {64, 48}});
}

TEST(Render, MakesTheSameFrameForAnyNumberOfThreads) {
  const Scene scene = scene_of(hills(), {60, 90}, sun_at(200, 12));
  const Frame one = render(scene, hills_camera(), {.threads = 1, .keep_samples = true});
  for (const int threads : {0, 2, 4, 7}) {
    const Frame many = render(scene, hills_camera(), {.threads = threads, .keep_samples = true});
    EXPECT_EQ(many.image.pixels(), one.image.pixels());
    for (std::size_t i = 0; i < one.samples.pixels().size(); ++i) {
      ASSERT_EQ(many.samples.pixels()[i].position_m, one.samples.pixels()[i].position_m);
      ASSERT_EQ(many.samples.pixels()[i].normal, one.samples.pixels()[i].normal);
      ASSERT_EQ(many.samples.pixels()[i].object_id, one.samples.pixels()[i].object_id);
    }
    EXPECT_EQ(many.counts.tests, one.counts.tests);
  }
}

TEST(Render, KeepsWhatThePixelsCentreMeetsAndCountsIt) {
  const Scene scene = scene_of(hills(), {60, 90}, sun_at(200, 12));
  const Camera camera = hills_camera();
  const Frame frame = render(scene, camera, {.keep_samples = true});
  std::int64_t hits = 0;
  for (int row = 0; row < 48; ++row) {
    for (int column = 0; column < 64; ++column) {
      const PixelSample& sample = frame.samples.at(column, row);
      const auto hit = scene.terrain->first_hit(camera.ray({column + 0.5, row + 0.5}));
      ASSERT_EQ(sample.object_id, hit ? PixelSample::kGround : PixelSample::kNothing);
      if (!hit) continue;
      ++hits;
      ASSERT_LT(glm::distance(sample.position_m, hit->position_m), 1e-9);
      ASSERT_NEAR(glm::length(sample.normal), 1, 1e-6);
    }
  }
  EXPECT_GT(hits, 1000);
  EXPECT_LT(hits, 64 * 48);
  EXPECT_EQ(frame.counts.hits, hits);
  EXPECT_EQ(frame.counts.rays, 64 * 48);
  EXPECT_LE(frame.counts.shadow_rays, hits);
  EXPECT_GE(frame.counts.tests, hits);
}

TEST(Render, KeepsNoSamplesUnasked) {
  EXPECT_TRUE(render(scene_of(hills(), {60, 90}, {0, 0, 1}), hills_camera()).samples.empty());
}

TEST(Render, ReportsProgressUpToAllOfIt) {
  std::vector<double> shares;
  static_cast<void>(
      render(scene_of(hills(), {60, 90}, {0, 0, 1}), hills_camera(),
             {.threads = 1, .progress = [&](double share) { shares.push_back(share); }}));
  ASSERT_FALSE(shares.empty());
  EXPECT_DOUBLE_EQ(*std::max_element(shares.begin(), shares.end()), 1);
  EXPECT_GT(shares.front(), 0);
}

TEST(Render, EndsWithWhatItsProgressThrows) {
  const auto stop = [](double share) {
    if (share > 0.5) throw std::domain_error("stop");
  };
  EXPECT_THROW(static_cast<void>(render(scene_of(hills(), {60, 90}, {0, 0, 1}), hills_camera(),
                                        {.threads = 3, .progress = stop})),
               std::domain_error);
}

}  // namespace
}  // namespace terrview

// More rays a pixel: render/antialias.h and sample_offset().
#include "render/antialias.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "tests/render/hills.h"

namespace terrview {
namespace {

TEST(SampleOffset, BeginsAtTheCentreAndStaysInThePixel) {
  EXPECT_EQ(sample_offset(0), glm::dvec2(0.5, 0.5));
  for (int i = 0; i < 1024; ++i) {
    const glm::dvec2 at = sample_offset(i);
    EXPECT_TRUE(at.x >= 0 && at.y >= 0 && at.x < 1 && at.y < 1) << i;
  }
}

TEST(SampleOffset, SpreadsEveryNumberOfRaysEvenlyOverEachSide) {
  for (const int count : {4, 5, 16, 64, 100, 256}) {
    for (int axis = 0; axis < 2; ++axis) {
      std::vector<double> at;
      for (int i = 0; i < count; ++i) at.push_back(sample_offset(i)[axis]);
      std::sort(at.begin(), at.end());
      double widest = at.front() + 1 - at.back();
      for (std::size_t i = 1; i < at.size(); ++i) widest = std::max(widest, at[i] - at[i - 1]);
      EXPECT_LT(widest, 2.6 / count) << count;
    }
  }
}

// How many of the first `count` rays go through each of side x side squares of the pixel.
std::vector<int> rays_in_squares(int count, int side) {
  std::vector<int> squares(static_cast<std::size_t>(side * side), 0);
  for (int i = 0; i < count; ++i) {
    const glm::ivec2 at(static_cast<double>(side) * sample_offset(i));
    ++squares[static_cast<std::size_t>(at.y * side + at.x)];
  }
  return squares;
}

TEST(SampleOffset, SpreadsRaysEvenlyOverThePixel) {
  for (const int rays : rays_in_squares(4, 2)) EXPECT_EQ(rays, 1);
  for (const int rays : rays_in_squares(16, 4)) EXPECT_EQ(rays, 1);
  for (const int rays : rays_in_squares(256, 8)) EXPECT_NEAR(rays, 4, 2);
}

// The plain twin: every ray on its own.
glm::vec3 mean_of_rays(const Scene& scene, const Camera& camera, glm::ivec2 pixel, int samples) {
  glm::vec3 sum(0);
  for (int i = 0; i < samples; ++i) {
    const Ray ray = camera.ray(glm::dvec2(pixel) + sample_offset(i));
    const std::optional<Hit> hit = scene.terrain->first_hit(ray);
    ShadowCounts shadows;
    sum += shade(scene, {pixel_width(camera)}, {&ray, 1}, {{hit}}, shadows).front().color;
  }
  return sum / static_cast<float>(samples);
}

TEST(Supersampling, IsTheMeanOfItsRays) {
  const Scene scene = hills_scene();
  for (const Camera& camera : {level_camera({32, 24}), tilted_camera({32, 24})}) {
    const Frame frame = render(scene, camera, {.samples = 7});
    EXPECT_EQ(frame.counts.rays, 7 * 32 * 24);
    for (int row = 0; row < 24; ++row) {
      for (int column = 0; column < 32; ++column) {
        const glm::vec3 expected = mean_of_rays(scene, camera, {column, row}, 7);
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(frame.image.at(column, row)[i], expected[i], 1e-5F);
      }
    }
  }
}

TEST(Adaptive, PixelsAreTheMeanOfOneFourOrSixteenRays) {
  const Scene scene = hills_scene();
  const Camera camera = tilted_camera({64, 48});
  const Frame frame = render(scene, camera, {.samples = 0});
  int counts[3] = {0, 0, 0};
  std::int64_t rays = 0;
  for (int row = 0; row < 48; ++row) {
    for (int column = 0; column < 64; ++column) {
      bool found = false;
      for (int choice = 0; choice < 3 && !found; ++choice) {
        const int samples = choice == 0 ? 1 : choice == 1 ? 4 : 16;
        const glm::vec3 step =
            frame.image.at(column, row) - mean_of_rays(scene, camera, {column, row}, samples);
        found = glm::length(step) < 1e-5F;
        counts[choice] += found ? 1 : 0;
        rays += found ? samples : 0;
      }
      EXPECT_TRUE(found) << column << ' ' << row;
    }
  }
  for (const int count : counts) EXPECT_GT(count, 20);
  EXPECT_NEAR(static_cast<double>(rays), static_cast<double>(frame.counts.rays),
              0.02 * static_cast<double>(rays));
}

TEST(Adaptive, ComesCloseToManyRaysEverywhereForFewOfThem) {
  const Scene scene = hills_scene();
  const Camera camera = tilted_camera({96, 72});
  const Frame many = render(scene, camera, {.samples = 64});
  const Frame adaptive = render(scene, camera, {.samples = 0});
  const Frame one = render(scene, camera, {.samples = 1});
  EXPECT_GT(psnr_db(adaptive.image, many.image), psnr_db(one.image, many.image) + 9);
  EXPECT_LT(adaptive.counts.rays, 6 * one.counts.rays);
}

// A roof's edge against the sky: the share of each pixel that the ground covers is known.
TEST(Adaptive, TakesTheStairsOutOfASkyline) {
  Scene scene = hills_scene();
  scene.terrain = std::make_shared<Terrain>(make_terrain(
      make_grid(41, 3, [](int column, int row) { return row == 0 ? 20.0 + column : -500.0; }),
      Place{.eye_uv = {20, 2}, .spacing_m = {10, 100}, .eye_height_m = 30},
      SurfaceModel::triangles));
  scene.tints = {.stops = {{0, {0, 0, 0}}}};
  scene.sky = {.horizon = glm::vec3(1), .zenith = glm::vec3(1), .sunward = {}};
  // The skyline at 200 m is z = 10 + x / 10.
  const Camera camera({.fov_rad = 40 * kRadians, .size_px = {80, 60}});
  const Image image = render(scene, camera, {.samples = 0}).image;
  const double k = std::tan(20 * kRadians) / 40;
  int partly = 0;
  for (int column = 0; column < 80; ++column) {
    const double x = (column + 0.5 - 40) * k;
    const double skyline_row = 30 - (10.0 / 200 + x / 10) / k;
    for (int row = 0; row < 60; ++row) {
      const double sky = std::clamp(skyline_row - row, 0.0, 1.0);
      const double seen = image.at(column, row).x;
      EXPECT_NEAR(seen, sky, 0.07) << column << ' ' << row;
      partly += seen > 0.05 && seen < 0.95 ? 1 : 0;
    }
  }
  EXPECT_GT(partly, 40);
}

TEST(Adaptive, SpendsNothingOnAnEmptySky) {
  const Camera up({.pitch_rad = 60 * kRadians, .size_px = {40, 30}});
  EXPECT_EQ(render(hills_scene(), up, {.samples = 0}).counts.rays, 40 * 30);
}

TEST(Adaptive, IsTheSamePictureForAnyNumberOfThreadsAndWithoutCoherence) {
  Scene scene = hills_scene();
  scene.light.sun_radius_rad = 0.00465;
  scene.air = {.extinction_per_m = 1e-4, .haze_px_per_m = 1.0 / 4000};
  for (const Camera& camera : {level_camera({80, 60}), tilted_camera({80, 60})}) {
    for (const int samples : {0, 3}) {
      const Frame one = render(scene, camera, {.threads = 1, .samples = samples});
      for (const int threads : {2, 5}) {
        const Frame other = render(scene, camera, {.threads = threads, .samples = samples});
        EXPECT_EQ(one.image.pixels(), other.image.pixels());
        EXPECT_EQ(one.counts.rays, other.counts.rays);
        EXPECT_EQ(one.counts.shadow_rays, other.counts.shadow_rays);
      }
      EXPECT_EQ(
          one.image.pixels(),
          render(scene, camera, {.coherence = Coherence::off, .samples = samples}).image.pixels());
    }
  }
}

}  // namespace
}  // namespace terrview

// Level of detail: render/ground_detail.h.
#include "render/ground_detail.h"

#include <gtest/gtest.h>

#include <random>

#include <glm/geometric.hpp>

#include "render/plan.h"
#include "tests/render/hills.h"

namespace terrview {
namespace {

// Rough ground, 10 m a post, seen from far above: 6 posts a pixel.
Scene rough_scene(bool detail) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> height_m(0, 15);
  const Place place{.eye_uv = {200, 200}, .spacing_m = {10, 10}, .eye_height_m = 3000};
  Scene scene;
  scene.terrain = std::make_shared<Terrain>(
      make_terrain(make_grid(401, 401, [&](int, int) { return height_m(random); }), place,
                   SurfaceModel::hyperboloid));
  scene.tints = {.stops = {{0, {0.2F, 0.2F, 0.2F}}, {15, {0.8F, 0.8F, 0.8F}}}};
  scene.light = {.towards_sun = sun_at(315, 35), .casts_shadows = false};
  if (detail) scene.detail = std::make_shared<GroundDetail>(*scene.terrain);
  return scene;
}

// How much the picture changes when the camera turns by a tenth of a pixel, rms in sRGB.
double sparkle(const Scene& scene) {
  const auto picture = [&](double shift_px) {
    const double per_px = 0.02;
    return render(scene, Camera({.heading_rad = 0,
                                 .pitch_rad = (-90 + shift_px * per_px / kRadians) * kRadians,
                                 .fov_rad = 2 * std::atan(per_px * 24),
                                 .size_px = {48, 48}}))
        .image;
  };
  return std::pow(10, -psnr_db(picture(0), picture(0.1)) / 20);
}

TEST(GroundDetail, KeepsFarGroundFromSparkling) {
  EXPECT_LT(sparkle(rough_scene(true)), sparkle(rough_scene(false)) / 4);
}

TEST(GroundDetail, ShowsTheMeanOfManyRays) {
  const Camera camera({.pitch_rad = -90 * kRadians, .fov_rad = 0.9, .size_px = {24, 24}});
  const Image many = render(rough_scene(false), camera, {.samples = 256}).image;
  const Image one = render(rough_scene(false), camera).image;
  const Image averaged = render(rough_scene(true), camera).image;
  EXPECT_GT(psnr_db(averaged, many), psnr_db(one, many) + 6);
}

TEST(GroundDetail, LeavesNearGroundAsItIs) {
  Scene scene = hills_scene();
  const Camera camera = level_camera({400, 300});
  const Frame without = render(scene, camera, {.keep_samples = true});
  scene.detail = std::make_shared<GroundDetail>(*scene.terrain);
  const Frame with = render(scene, camera, {.keep_samples = true});
  const double per_px = camera.per_px();
  int near = 0;
  for (std::size_t i = 0; i < with.samples.pixels().size(); ++i) {
    const PixelSample& sample = with.samples.pixels()[i];
    if (sample.object_id == PixelSample::kNothing) continue;
    // Even seen at its flattest, a pixel covers less than a post of 100 m.
    if (16 * per_px * glm::length(sample.position_m) >= 100) continue;
    ++near;
    EXPECT_EQ(with.image.pixels()[i], without.image.pixels()[i]);
  }
  EXPECT_GT(near, 1000);
}

// The area on the map of what a square 1 wide across parallel rays covers of a plane.
double covered(const glm::dvec3& direction, const glm::dvec3& normal) {
  const glm::dvec3 away = glm::normalize(direction);
  const glm::dvec3 across = glm::normalize(glm::cross(away, glm::dvec3(0.3, 0.5, 0.1)));
  const auto on_plane = [&](double x, double y) {
    const glm::dvec3 from = x * across + y * glm::cross(away, across);
    return glm::dvec2(from - away * (glm::dot(from, normal) / glm::dot(away, normal)));
  };
  const glm::dvec2 a = on_plane(1, 1) - on_plane(0, 0);
  const glm::dvec2 b = on_plane(1, 0) - on_plane(0, 1);
  return std::abs(a.x * b.y - a.y * b.x) / 2;
}

TEST(GroundDetail, CountsAPixelByItsAreaOnTheMap) {
  const Scene scene = rough_scene(true);
  const Hit hit = scene.terrain->first_hit({.direction = {0.01, 0.02, -1}}).value();
  const Ray plumb{.direction = {0, 0, -1}};
  for (const glm::dvec3& normal : {glm::dvec3(0, 0, 1), {0.6, 0, 0.8}, {-0.7, 0.7, 0.14}}) {
    const GroundDetail::Ground exact{glm::normalize(normal), 7};
    for (const glm::dvec3& direction :
         {glm::dvec3(0, 0, -3), {1e-9, 0, -1}, {0.2, -0.1, -1}, {3, 5, -2}}) {
      for (const double width_m : {11.0, 17.0, 45.0}) {
        const double side_m = width_m * std::sqrt(covered(direction, exact.normal));
        const Ray ray{.direction = direction};
        const auto seen = scene.detail->seen(*scene.terrain, ray, hit, width_m, exact);
        const auto expected = scene.detail->seen(*scene.terrain, plumb, hit, side_m, exact);
        EXPECT_LT(glm::distance(seen.normal, expected.normal), 1e-6);
        EXPECT_NEAR(seen.height_m, expected.height_m, 1e-6);
      }
    }
  }
}

TEST(GroundDetail, ShowsFromStraightAboveWhatAMapShows) {
  const Scene scene = rough_scene(true);
  const Camera camera({.projection = Projection::orthographic,
                       .pitch_rad = -90 * kRadians,
                       .width_m = 1000,
                       .size_px = {40, 40}});
  const Image picture = render(scene, camera).image;
  // Pixels of 2.5 posts about the post (200, 200).
  const PlanFrame map =
      render_plan(scene, {.size_px = {40, 40}, .corner_uv = {150, 150}, .step_uv = {2.5, 2.5}});
  for (std::size_t i = 0; i < picture.pixels().size(); ++i)
    ASSERT_LT(glm::distance(picture.pixels()[i], map.image.pixels()[i]), 1e-4F) << i;
}

TEST(GroundDetail, TakesOverWithoutAStep) {
  const Scene scene = rough_scene(true);
  const Hit hit = scene.terrain->first_hit({.direction = {0.01, 0.02, -1}}).value();
  const Ray ray{.direction = {0, 0, -1}};
  const GroundDetail::Ground exact{scene.terrain->smooth_normal(hit), 7};
  GroundDetail::Ground last = exact;
  for (double width_m = 5; width_m < 300; width_m *= 1.01) {
    const auto seen = scene.detail->seen(*scene.terrain, ray, hit, width_m, exact);
    if (width_m < 6) {
      EXPECT_EQ(seen.normal, exact.normal);
    }
    EXPECT_LT(glm::distance(seen.normal, last.normal), 0.03) << width_m;
    EXPECT_LT(std::abs(seen.height_m - last.height_m), 0.3) << width_m;
    last = seen;
  }
}

}  // namespace
}  // namespace terrview

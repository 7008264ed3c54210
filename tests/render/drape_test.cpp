// Pictures over the ground: render/drape.h.
#include "render/drape.h"

#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "render/objects/scene_objects.h"
#include "tests/render/hills.h"
#include "tests/support/random_scene.h"

namespace terrview {
namespace {

// `scale` pixels a post.
class ScaledMap final : public PixelMap {
 public:
  explicit ScaledMap(double scale) : scale_(scale) {}
  [[nodiscard]] glm::dvec2 to_pixels(glm::dvec2 uv) const override { return scale_ * uv; }
  [[nodiscard]] glm::dmat2 jacobian(glm::dvec2 /*uv*/) const override { return glm::dmat2(scale_); }

 private:
  double scale_;
};

double area(const glm::dmat2& sides) { return std::abs(glm::determinant(sides)); }

TEST(Footprint, OfARayFromAboveIsASquare) {
  const glm::dmat2 sides = footprint({0, 0, -3}, {0, 0, 1});
  EXPECT_NEAR(area(sides), 1, 1e-12);
  EXPECT_NEAR(glm::dot(sides[0], sides[1]), 0, 1e-12);
  EXPECT_NEAR(glm::length(sides[0]), 1, 1e-12);
}

TEST(Footprint, OfASlantedRayIsLongAlongIt) {
  const double elevation = 0.1;
  const glm::dvec3 ray(std::cos(elevation), 0, -std::sin(elevation));
  const glm::dmat2 sides = footprint(ray, {0, 0, 1});
  EXPECT_NEAR(area(sides), 1 / std::sin(elevation), 1e-9);
  EXPECT_NEAR(glm::length(glm::transpose(sides) * glm::dvec2(1, 0)), 1 / std::sin(elevation), 1e-9);
  EXPECT_NEAR(glm::length(glm::transpose(sides) * glm::dvec2(0, 1)), 1, 1e-9);
}

TEST(Footprint, OnASlopeThatFacesTheRayIsItsPlan) {
  const glm::dvec3 ray = glm::normalize(glm::dvec3(1, 0, -1));
  EXPECT_NEAR(area(footprint(ray, -ray)), std::sqrt(0.5), 1e-12);
}

TEST(Footprint, HasTheAreaOfItsSides) {
  Random random(3);
  const auto direction = [&random](double up) {
    const double x = random.uniform(-1, 1);
    const double y = random.uniform(-1, 1);
    return glm::dvec3(x, y, random.uniform(-up, up));
  };
  for (int i = 0; i < 10000; ++i) {
    const glm::dvec3 normal = glm::normalize(direction(0.5) + glm::dvec3(0, 0, 1));
    glm::dvec3 ray = direction(3);
    // Half of them graze.
    if (i % 2 != 0) ray = glm::cross(normal, ray) + random.uniform(-0.01, 0.01) * normal;
    const double expected = area(footprint(ray, normal));
    EXPECT_NEAR(footprint_area(ray, normal), expected, 1e-12 * (1 + expected));
  }
}

TEST(Footprint, NeverGrowsBeyondBounds) {
  EXPECT_LE(footprint_area({1, 0, 0}, {0, 0, 1}), 256 + 1e-9);
  EXPECT_LE(area(footprint({1, 0, 0}, {0, 0, 1})), 256 + 1e-9);
}

// Level ground under a fine checkerboard, seen far away.
Scene checkered_scene(bool detail) {
  Raster<glm::u8vec4> picture(1200, 1200);
  for (int row = 0; row < 1200; ++row)
    for (int column = 0; column < 1200; ++column)
      picture.at(column, row) = (column / 3 + row / 3) % 2 == 0 ? glm::u8vec4(230, 230, 230, 255)
                                                                : glm::u8vec4(20, 60, 20, 255);
  Scene scene = scene_over(make_grid(120, 120, [](int, int) { return 0.0; }), 400);
  scene.light = {.towards_sun = {0, 0, 1}, .casts_shadows = false};
  scene.drape = std::make_shared<Drape>(
      PicturePyramid(std::move(picture)),
      std::vector<std::shared_ptr<const PixelMap>>{std::make_shared<ScaledMap>(10)});
  if (detail) scene.detail = std::make_shared<GroundDetail>(*scene.terrain);
  return scene;
}

TEST(Drape, ShowsTheMeanOfManyRays) {
  const Camera camera({.pitch_rad = -12 * kRadians, .fov_rad = 0.7, .size_px = {64, 40}});
  const Image many = render(checkered_scene(false), camera, {.samples = 256}).image;
  const Image one = render(checkered_scene(false), camera).image;
  const Image filtered = render(checkered_scene(true), camera).image;
  EXPECT_GT(psnr_db(filtered, many), psnr_db(one, many) + 6);
}

TEST(Drape, IsTheGroundsColorAndTheTintsAreWhereItHasNone) {
  Scene scene = checkered_scene(true);
  Raster<glm::u8vec4> red(600, 2000, glm::u8vec4(255, 0, 0, 255));
  scene.drape = std::make_shared<Drape>(
      PicturePyramid(std::move(red)),
      std::vector<std::shared_ptr<const PixelMap>>{std::make_shared<ScaledMap>(10)});
  scene.tints = {.stops = {{0, {0, 1, 0}}}};
  const Image image =
      render(scene, Camera({.pitch_rad = -40 * kRadians, .fov_rad = 0.9, .size_px = {40, 20}}))
          .image;
  // The picture covers the western half; the eye is in the middle.
  EXPECT_GT(image.at(5, 10).r, 0.5F);
  EXPECT_EQ(image.at(5, 10).g, 0);
  EXPECT_GT(image.at(34, 10).g, 0.5F);
  EXPECT_EQ(image.at(34, 10).r, 0);
}

}  // namespace
}  // namespace terrview

// Pictures at any place and width: render/picture_pyramid.h.
#include "render/picture_pyramid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>

#include "render/color_ramp.h"

namespace terrview {
namespace {

Raster<glm::u8vec4> random_picture(int width_px, int height_px) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> byte(0, 255);
  Raster<glm::u8vec4> picture(width_px, height_px);
  for (int row = 0; row < height_px; ++row)
    for (int column = 0; column < width_px; ++column)
      picture.at(column, row) = {byte(random), byte(random), byte(random), 255};
  return picture;
}

glm::vec4 linear(glm::u8vec4 pixel) { return {from_srgb8(pixel.r, pixel.g, pixel.b), 1}; }

glm::vec4 mean_of(const Raster<glm::u8vec4>& picture, glm::ivec2 first, glm::ivec2 size) {
  glm::vec4 sum(0);
  for (int row = 0; row < size.y; ++row)
    for (int column = 0; column < size.x; ++column)
      sum += linear(picture.at(first.x + column, first.y + row));
  return sum / static_cast<float>(size.x * size.y);
}

void expect_near(const glm::vec4& found, const glm::vec4& expected, float tolerance) {
  EXPECT_LE(glm::distance(found, expected), tolerance)
      << found.r << ' ' << found.g << ' ' << found.b << ' ' << found.a << " instead of "
      << expected.r << ' ' << expected.g << ' ' << expected.b << ' ' << expected.a;
}

TEST(PicturePyramid, ShowsAPixelAtItsCentre) {
  const auto picture = random_picture(7, 5);
  const PicturePyramid pyramid(picture);
  for (int row = 0; row < 5; ++row)
    for (int column = 0; column < 7; ++column)
      EXPECT_EQ(pyramid.at({column + 0.5, row + 0.5}, 0), linear(picture.at(column, row)));
}

TEST(PicturePyramid, MixesLinearLightBetweenCentres) {
  const auto picture = random_picture(4, 4);
  const glm::vec4 upper = linear(picture.at(1, 1)) * 0.75F + linear(picture.at(2, 1)) * 0.25F;
  const glm::vec4 lower = linear(picture.at(1, 2)) * 0.75F + linear(picture.at(2, 2)) * 0.25F;
  expect_near(PicturePyramid(picture).at({1.75, 2.0}, 0), (upper + lower) / 2.0F, 1e-6F);
}

TEST(PicturePyramid, ShowsTheMeanOfABlockAtItsMiddle) {
  const auto picture = random_picture(64, 64);
  const PicturePyramid pyramid(picture);
  for (const int level : {1, 2, 3}) {
    const int side = 1 << level;
    expect_near(pyramid.at(glm::dvec2(4.5 * side, 2.5 * side), level),
                mean_of(picture, {4 * side, 2 * side}, {side, side}), 0.012F);
  }
}

TEST(PicturePyramid, FadesIntoWhatIsBesideItAndIsNothingBeyond) {
  const PicturePyramid white(Raster<glm::u8vec4>(3, 3, glm::u8vec4(255)));
  EXPECT_FLOAT_EQ(white.at({0, 1.5}, 0).a, 0.5F);
  EXPECT_FLOAT_EQ(white.at({3, 3}, 0).a, 0.25F);
  EXPECT_EQ(white.at({-0.5, 1.5}, 0), glm::vec4(0));
  EXPECT_EQ(white.at({1.5, 3.5}, 0), glm::vec4(0));
  EXPECT_EQ(white.at({1e300, -1e300}, 0), glm::vec4(0));
  EXPECT_EQ(white.at(glm::dvec2(std::numeric_limits<double>::quiet_NaN()), 0), glm::vec4(0));
}

TEST(PicturePyramid, LeavesHolesOutOfItsMeans) {
  Raster<glm::u8vec4> picture(2, 2, glm::u8vec4(0, 0, 0, 0));
  picture.at(1, 0) = {200, 100, 50, 255};
  const glm::vec4 mean = PicturePyramid(picture).at({1, 1}, 1);
  expect_near(mean, linear({200, 100, 50, 255}) * 0.25F, 0.002F);
}

TEST(PicturePyramid, AWideFootprintIsTheMeanUnderIt) {
  // A gradient, on which where the footprint lies shows, and stripes that must vanish.
  Raster<glm::u8vec4> picture(256, 256);
  for (int row = 0; row < 256; ++row)
    for (int column = 0; column < 256; ++column) {
      const int stripe = (row + column) % 2 * 40;
      picture.at(column, row) = {column / 2 + stripe, row / 2 + stripe, 90, 255};
    }
  const PicturePyramid pyramid(picture);
  expect_near(pyramid.mean({100, 60}, glm::dmat2(16, 0, 0, 16)),
              mean_of(picture, {92, 52}, {16, 16}), 0.006F);
  // Longer than wide, in both directions, and of any two sides that span the same.
  expect_near(pyramid.mean({128, 100}, glm::dmat2(64, 0, 0, 8)),
              mean_of(picture, {96, 96}, {64, 8}), 0.008F);
  expect_near(pyramid.mean({128, 100}, glm::dmat2(0, 64, 8, 0)),
              mean_of(picture, {124, 68}, {8, 64}), 0.008F);
}

TEST(PicturePyramid, ALongFootprintIsNotBlurredAcross) {
  // Half black, half white: beside the border a footprint along it sees one colour alone.
  Raster<glm::u8vec4> picture(128, 128, glm::u8vec4(0, 0, 0, 255));
  for (int row = 64; row < 128; ++row)
    for (int column = 0; column < 128; ++column) picture.at(column, row) = glm::u8vec4(255);
  const PicturePyramid pyramid(picture);
  EXPECT_LT(pyramid.mean({64, 59}, glm::dmat2(40, 0, 0, 4)).r, 0.01F);
  EXPECT_GT(pyramid.mean({64, 69}, glm::dmat2(40, 0, 0, 4)).r, 0.99F);
}

}  // namespace
}  // namespace terrview

// Textures at places where their values are known.
#include "render/materials/texture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "render/color_ramp.h"
#include "sky/solid_field.h"

namespace terrview {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(Mapping, HasKnownPlaces) {
  EXPECT_EQ(mapped(Mapping::planar, {3, -4, 9}), glm::dvec2(3, -4));
  EXPECT_EQ(mapped(Mapping::cylindrical, {2, 0, 7}), glm::dvec2(0, 7));
  EXPECT_EQ(mapped(Mapping::cylindrical, {0, 3, -1}), glm::dvec2(0.25, -1));
  EXPECT_EQ(mapped(Mapping::cylindrical, {-3, 0, 0}), glm::dvec2(0.5, 0));
  EXPECT_EQ(mapped(Mapping::cylindrical, {0, -3, 0}), glm::dvec2(0.75, 0));
  EXPECT_EQ(mapped(Mapping::spherical, {5, 0, 0}), glm::dvec2(0, 0.5));
  EXPECT_NEAR(mapped(Mapping::spherical, {0, 1, 1}).y, 0.75, 1e-15);
}

TEST(Mapping, HasPolesAndASeam) {
  EXPECT_EQ(mapped(Mapping::spherical, {0, 0, 2}).y, 1);
  EXPECT_EQ(mapped(Mapping::spherical, {0, 0, -2}).y, 0);
  EXPECT_EQ(mapped(Mapping::spherical, {0, 0, 0}).y, 0.5);
  for (const double off : {1e-3, 1e-9, 1e-18, 1e-300, 0.0}) {
    const double above = mapped(Mapping::spherical, {1, off, 0}).x;
    const double below = mapped(Mapping::spherical, {1, -off, 0}).x;
    EXPECT_NEAR(above, off / (2 * kPi), 1e-9);
    EXPECT_LT(below, 1);  // never the end of the range
    EXPECT_NEAR(below - std::round(below), -off / (2 * kPi), 1e-9);
  }
}

ShadingPoint seen_from_above(const glm::dvec3& position_m, double width_m = 1e-6) {
  return {.position_m = position_m, .width_m = width_m};
}

// 4 x 2 pixels of one colour each.
std::shared_ptr<const PicturePyramid> small_picture() {
  Raster<glm::u8vec4> picture(4, 2);
  for (int row = 0; row < 2; ++row)
    for (int column = 0; column < 4; ++column)
      picture.at(column, row) = glm::u8vec4(60 * column, 100 * row, 50, 255);
  return std::make_shared<const PicturePyramid>(picture);
}

void expect_near(const glm::vec3& color, const glm::vec3& expected, double tolerance) {
  EXPECT_LT(glm::length(color - expected), tolerance);
}

TEST(PictureTexture, ShowsThePixelsUprightAndRepeated) {
  const ColorShade texture = picture_texture(small_picture(), {});
  for (const glm::dvec2 copy : {glm::dvec2(0, 0), glm::dvec2(3, -2)}) {
    for (int column = 0; column < 4; ++column) {
      const glm::dvec2 uv = copy + glm::dvec2((column + 0.5) / 4, 0.75);
      expect_near(texture->at(seen_from_above({uv, 0})),
                  from_srgb8(60.0F * static_cast<float>(column), 0, 50), 1e-4);
    }
    expect_near(texture->at(seen_from_above({copy + glm::dvec2(0.125, 0.25), 0})),
                from_srgb8(0, 100, 50), 1e-4);
  }
}

TEST(PictureTexture, IsLaidByItsPlacement) {
  // Four metres to a picture, from (10, 20).
  const glm::dmat4 to_texture = glm::scale(glm::dmat4(1), glm::dvec3(0.25)) *
                                glm::translate(glm::dmat4(1), glm::dvec3(-10, -20, 0));
  const ColorShade texture = picture_texture(small_picture(), {.to_texture = to_texture});
  expect_near(texture->at(seen_from_above({12.5, 23, 0})), from_srgb8(120, 0, 50), 1e-4);
}

TEST(PictureTexture, HasNoSeam) {
  const ColorShade around = picture_texture(small_picture(), {.mapping = Mapping::spherical});
  for (const double latitude : {-1.2, 0.0, 0.3, 1.5}) {
    const auto at = [&](double longitude) {
      const glm::dvec3 place(std::cos(latitude) * std::cos(longitude),
                             std::cos(latitude) * std::sin(longitude), std::sin(latitude));
      return around->at(
          {.position_m = place, .normal = place, .towards_eye = place, .width_m = 1e-6});
    };
    expect_near(at(1e-7), at(-1e-7), 1e-5);
    // Half-way between the last column and the first.
    const float row = latitude < 0 ? 100 : 0;
    if (latitude == -1.2 || latitude == 1.5)
      expect_near(at(0), 0.5F * (from_srgb8(180, row, 50) + from_srgb8(0, row, 50)), 1e-3);
  }
}

TEST(PictureTexture, EndsAtThePoles) {
  const ColorShade around = picture_texture(small_picture(), {.mapping = Mapping::spherical});
  const auto green_at = [&](const glm::dvec3& pole) {
    return around->at({.position_m = pole, .normal = pole, .towards_eye = pole, .width_m = 1e-6}).g;
  };
  EXPECT_NEAR(green_at({0, 0, 1}), 0, 1e-4);
  EXPECT_NEAR(green_at({0, 0, -1}), from_srgb8(0, 100, 0).g, 1e-4);
}

TEST(PictureTexture, IsItsMeanWhereAPixelCoversMuchOfIt) {
  Raster<glm::u8vec4> picture(64, 64);
  for (int row = 0; row < 64; ++row)
    for (int column = 0; column < 64; ++column)
      picture.at(column, row) =
          (row + column) % 2 == 0 ? glm::u8vec4(255) : glm::u8vec4(0, 0, 0, 255);
  const ColorShade texture = picture_texture(std::make_shared<const PicturePyramid>(picture), {});
  for (const double at : {0.0, 0.3, 0.511, 0.98})
    expect_near(texture->at(seen_from_above({at, at / 2, 0}, 0.25)), glm::vec3(0.5F), 0.02);
}

// However many copies fall into a pixel, in one direction or in both.
TEST(PictureTexture, IsItsMeanWhereAPixelCoversManyCopies) {
  Raster<glm::u8vec4> picture(64, 16);
  glm::vec3 mean(0);
  for (int row = 0; row < 16; ++row)
    for (int column = 0; column < 64; ++column) {
      picture.at(column, row) = glm::u8vec4(4 * column, 255 - 15 * row, 128, 255);
      mean += from_srgb8(4.0F * static_cast<float>(column), 255 - 15.0F * static_cast<float>(row),
                         128) /
              1024.0F;
    }
  const ColorShade texture = picture_texture(std::make_shared<const PicturePyramid>(picture), {});
  const glm::dvec3 slanted = glm::normalize(glm::dvec3(0.3, -1, 0.02));
  for (const double copies : {1.0, 3.0, 10.0, 1000.0})
    for (const double at : {0.0, 0.3, 0.511, 0.98}) {
      const glm::dvec3 place(at, at / 2, 0);
      expect_near(texture->at(seen_from_above(place, copies)), mean, 0.03);
      const ShadingPoint aslant{
          .position_m = place, .towards_eye = slanted, .width_m = copies / 50};
      EXPECT_NEAR(texture->at(aslant).b, mean.b, 0.01);
    }
}

TEST(Checker, IsOneAndZeroByTurns) {
  const ScalarShade checks = checker({4, 2}, {});
  EXPECT_EQ(checks->at(seen_from_above({0.1, 0.1, 0})), 0);
  EXPECT_EQ(checks->at(seen_from_above({0.3, 0.1, 0})), 1);
  EXPECT_EQ(checks->at(seen_from_above({0.3, 0.6, 0})), 0);
  EXPECT_EQ(checks->at(seen_from_above({-0.1, 0.1, 0})), 1);
  EXPECT_EQ(checks->at(seen_from_above({-0.1, -0.1, 0})), 0);
}

TEST(SolidTexture, IsTheFieldWhereverItIsPut) {
  const FieldOptions options{.seed = 5, .levels = {4, 4}, .h = {0.7}};
  const SolidField field(options);
  const glm::dmat4 to_texture =
      glm::rotate(glm::scale(glm::dmat4(1), glm::dvec3(0.1)), 0.7, glm::dvec3(1, 2, 3)) *
      glm::translate(glm::dmat4(1), glm::dvec3(-10, -20, 5));
  const ScalarShade texture = solid_field(options, to_texture);
  for (int i = 0; i < 20; ++i) {
    const glm::dvec3 at(i * 3.7, 40 - i, i * i * 0.4);
    const glm::dvec3 inside(to_texture * glm::dvec4(at, 1));
    EXPECT_EQ(texture->at({.position_m = at}), field.at(inside));
    EXPECT_NEAR(texture->at({.position_m = at, .width_m = 2}), field.at(inside, 0.2), 1e-9);
  }
}

TEST(SolidTexture, OfMarbleHasTheTablesVeinWhereTheFieldIsZero) {
  const FieldOptions options{.seed = 5, .levels = {3, 3}, .h = {0.7}};
  const SolidField field(options);
  double low = 0;
  double high = 0;
  for (int i = 1; field.at({high, 0, 0}) * field.at({0, 0, 0}) > 0; ++i) high = 0.1 * i;
  for (int i = 0; i < 50; ++i) {
    const double middle = (low + high) / 2;
    (field.at({middle, 0, 0}) * field.at({0, 0, 0}) > 0 ? low : high) = middle;
  }
  const glm::vec3 vein = named_table("marble")->at(0.5);
  expect_near(marble(options, glm::dmat4(1))->at({.position_m = {low, 0, 0}}), vein, 1e-3);
}

TEST(SolidTexture, OfWoodIsRingsBentByTheField) {
  const FieldOptions options{.levels = {2, 2}};
  const ColorShade trunk = wood(options, glm::dmat4(1));
  const ColorTable table = *named_table("wood");
  const SolidField field(options);
  for (int i = 0; i < 30; ++i) {
    const glm::dvec3 at(0.4 * i, 0.3 * i, 5 * i);
    for (const double width_m : {0.0, 2.0}) {
      const double bend =
          0.8 * field.at(at / glm::dvec3(8, 8, 40), width_m / 8) / field.expected_deviation();
      const double turns = (0.5 * i + bend) / 12;
      const glm::vec3 expected = table.at(turns - std::floor(turns));
      expect_near(trunk->at({.position_m = at, .width_m = width_m}), expected, 0.02);
    }
  }
}

}  // namespace
}  // namespace terrview

// The algebra of shade trees, and what they do not evaluate.
#include "render/materials/shade_tree.h"

#include <gtest/gtest.h>

#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/fresnel.h"
#include "tests/render/materials/counting.h"

namespace terrview {
namespace {

const ShadingPoint kPoint{.position_m = {1, 2, 3}, .towards_eye = {0, 0.6, 0.8}};

TEST(ShadeTree, AddsMultipliesAndMixesScalars) {
  const ScalarShade two = constant(2.0);
  const ScalarShade five = constant(5.0);
  EXPECT_EQ(add(two, five)->at(kPoint), 7);
  EXPECT_EQ(multiply(two, five)->at(kPoint), 10);
  EXPECT_EQ(mix(two, five, constant(0.25))->at(kPoint), 2.75);
  EXPECT_EQ(mix(two, five, constant(-3.0))->at(kPoint), 2);
  EXPECT_EQ(mix(two, five, constant(3.0))->at(kPoint), 5);
}

TEST(ShadeTree, AddsMultipliesAndMixesColours) {
  const glm::vec3 a(1, 0.5F, 0);
  const glm::vec3 b(0.25F, 0.5F, 2);
  EXPECT_EQ(add(constant(a), constant(b))->at(kPoint), a + b);
  EXPECT_EQ(multiply(constant(a), constant(b))->at(kPoint), a * b);
  EXPECT_EQ(mix(constant(a), constant(b), constant(0.5))->at(kPoint), 0.5F * (a + b));
}

TEST(ShadeTree, ConvertsBetweenScalarsAndColours) {
  EXPECT_EQ(gray(constant(0.5))->at(kPoint), glm::vec3(0.5F));
  EXPECT_NEAR(luminance(gray(constant(0.5)))->at(kPoint), 0.5, 1e-12);
  EXPECT_NEAR(luminance(constant(glm::vec3(0, 1, 0)))->at(kPoint), 0.7152, 1e-12);
}

TEST(ShadeTree, KnowsHowTheSurfaceFacesTheEye) {
  EXPECT_NEAR(facing()->at(kPoint), 0.8, 1e-15);
  EXPECT_EQ(fresnel(1.5)->at(kPoint), fresnel_reflectance(0.8, 1.5));
  ShadingPoint inside = kPoint;
  inside.inside = true;
  EXPECT_EQ(fresnel(1.5)->at(inside), fresnel_reflectance(0.8, 1 / 1.5));
}

TEST(ShadeTree, ReadsTables) {
  const ColorTable table = *named_table("marble");
  for (const double address : {0.0, 0.3, 0.7, 1.0}) {
    const glm::vec3 color = tabled(constant(address), table)->at(kPoint);
    EXPECT_LT(glm::length(color - table.at(address)), 1e-3);
  }
}

TEST(ShadeTree, AsksOnlyForWhatMatters) {
  const auto asked = std::make_shared<Counting>(0.5);
  const auto spared = std::make_shared<Counting>(0.5);
  EXPECT_EQ(mix(asked, spared, constant(0.0))->at(kPoint), 0.5);
  EXPECT_EQ(mix(spared, asked, constant(1.0))->at(kPoint), 0.5);
  EXPECT_EQ(multiply(constant(0.0), spared)->at(kPoint), 0);
  EXPECT_EQ(asked->count, 2);
  EXPECT_EQ(spared->count, 0);
  EXPECT_EQ(mix(asked, spared, constant(0.5))->at(kPoint), 0.5);
  EXPECT_EQ(spared->count, 1);
}

}  // namespace
}  // namespace terrview

// One test per promise of render/color_ramp.h.
#include "render/color_ramp.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace terrview {
namespace {

constexpr glm::vec3 kRed(1, 0, 0);
constexpr glm::vec3 kGreen(0, 1, 0);
constexpr glm::vec3 kBlue(0, 0, 1);
constexpr glm::vec3 kFallback(0.25F, 0.5F, 0.75F);

ColorRamp three_stops(RampInterpolation interpolation) {
  return {{{0, kRed}, {100, kGreen}, {300, kBlue}}, interpolation, kFallback};
}

TEST(LinearRamp, MixesTheTwoStopsAroundAHeight) {
  const ColorRamp ramp = three_stops(RampInterpolation::linear);
  EXPECT_EQ(ramp.at(25), glm::vec3(0.75F, 0.25F, 0));
  EXPECT_EQ(ramp.at(250), glm::vec3(0, 0.25F, 0.75F));
  EXPECT_EQ(ramp.at(100), kGreen);
}

TEST(LinearRamp, KeepsItsFirstAndLastColourBeyondThem) {
  const ColorRamp ramp = three_stops(RampInterpolation::linear);
  EXPECT_EQ(ramp.at(-1e6), kRed);
  EXPECT_EQ(ramp.at(1e6), kBlue);
}

TEST(DiscreteRamp, TakesTheFirstStopThatIsNotBelow) {
  const ColorRamp ramp = three_stops(RampInterpolation::discrete);
  EXPECT_EQ(ramp.at(-5), kRed);
  EXPECT_EQ(ramp.at(0.001), kGreen);
  EXPECT_EQ(ramp.at(100), kGreen);
  EXPECT_EQ(ramp.at(299), kBlue);
  EXPECT_EQ(ramp.at(300.5), kFallback);
}

TEST(ExactRamp, KnowsTheHeightsOfItsStopsAlone) {
  const ColorRamp ramp = three_stops(RampInterpolation::exact);
  EXPECT_EQ(ramp.at(0), kRed);
  EXPECT_EQ(ramp.at(300), kBlue);
  EXPECT_EQ(ramp.at(300.0001), kFallback);
  EXPECT_EQ(ramp.at(-1), kFallback);
}

TEST(NearestRamp, TakesTheNearestStop) {
  const ColorRamp ramp = three_stops(RampInterpolation::nearest);
  EXPECT_EQ(ramp.at(-1000), kRed);
  EXPECT_EQ(ramp.at(49), kRed);
  EXPECT_EQ(ramp.at(51), kGreen);
  EXPECT_EQ(ramp.at(199), kGreen);
  EXPECT_EQ(ramp.at(201), kBlue);
  EXPECT_EQ(ramp.at(1000), kBlue);
}

TEST(EmptyRamp, HasItsFallbackEverywhere) {
  for (const auto interpolation : {RampInterpolation::linear, RampInterpolation::discrete,
                                   RampInterpolation::exact, RampInterpolation::nearest}) {
    const ColorRamp ramp{{}, interpolation, kFallback};
    EXPECT_EQ(ramp.at(12), kFallback);
  }
}

TEST(Srgb, ComesBackFromLinearForAll256Values) {
  for (int value = 0; value < 256; ++value) {
    const auto level = static_cast<float>(value);
    const glm::vec3 linear = from_srgb8(level, 255 - level, 0);
    EXPECT_EQ(std::lround(to_srgb(linear.x) * 255), value);
    EXPECT_EQ(std::lround(to_srgb(linear.y) * 255), 255 - value);
    EXPECT_EQ(linear.z, 0);
  }
}

TEST(Srgb, FollowsIec61966) {
  // Published pairs: half the light is 188 of 255, and 10 of 255 lies on the straight part.
  EXPECT_NEAR(to_srgb(0.5F), 0.735357F, 1e-6);
  EXPECT_NEAR(from_srgb8(128, 10, 255).x, 0.215861F, 1e-6);
  EXPECT_NEAR(from_srgb8(128, 10, 255).y, 10.0F / 255 / 12.92F, 1e-8);
  EXPECT_EQ(from_srgb8(128, 10, 255).z, 1);
}

TEST(Srgb, ClampsWhatNoFileHolds) {
  EXPECT_EQ(to_srgb(-3), 0);
  EXPECT_FLOAT_EQ(to_srgb(7), 1);
}

// Floats all over, and all those around the steps from one byte to the next.
TEST(Srgb, HasTheNearestByteOfEveryFloat) {
  const auto expect_nearest = [](float linear) {
    ASSERT_EQ(to_srgb8(linear), std::lround(to_srgb(linear) * 255)) << linear;
  };
  constexpr auto kTwo = std::bit_cast<std::uint32_t>(2.0F);
  for (std::uint32_t bits = 0; bits < kTwo; bits += 997) expect_nearest(std::bit_cast<float>(bits));
  for (int byte = 1; byte < 256; ++byte) {
    const float between = static_cast<float>(byte) - 0.5F;
    const auto near = std::bit_cast<std::uint32_t>(from_srgb8(between, 0, 0).x);
    for (std::uint32_t bits = near - 200; bits < near + 200; ++bits)
      expect_nearest(std::bit_cast<float>(bits));
  }
}

TEST(Srgb, HasTheBytesOfManyColoursAsOfEachComponent) {
  std::vector<glm::vec3> colors;
  for (int i = 0; i < 1000; ++i) {
    const float x = -0.1F + 0.0012F * static_cast<float>(i);
    colors.emplace_back(x, x * x, 1 - x);
  }
  colors.emplace_back(std::nanf(""), std::numeric_limits<float>::infinity(), -0.0F);
  const std::vector<std::uint8_t> bytes = to_srgb8(colors);
  ASSERT_EQ(bytes.size(), 3 * colors.size());
  for (std::size_t i = 0; i < bytes.size(); ++i)
    ASSERT_EQ(bytes[i], to_srgb8(colors[i / 3][static_cast<int>(i % 3)])) << i;
  EXPECT_TRUE(to_srgb8(std::vector<glm::vec3>{}).empty());
}

TEST(Srgb, IsNearlyFoundWithoutAPower) {
  constexpr auto kTwo = std::bit_cast<std::uint32_t>(2.0F);
  for (std::uint32_t bits = 0; bits < kTwo; bits += 997) {
    const auto linear = std::bit_cast<float>(bits);
    ASSERT_NEAR(nearly_srgb(linear), to_srgb(linear), 4e-6F) << linear;
  }
  EXPECT_EQ(nearly_srgb(1), 1);
  for (const float dark : {0.0F, -2.0F, std::nanf("")}) EXPECT_EQ(nearly_srgb(dark), 0);
}

TEST(Srgb, HasAByteForWhatNoFileHolds) {
  constexpr float kInfinite = std::numeric_limits<float>::infinity();
  for (const float dark : {0.0F, -0.0F, -1.0F, -kInfinite, std::nanf("")})
    EXPECT_EQ(to_srgb8(dark), 0);
  for (const float bright : {1.0F, 1.5F, kInfinite}) EXPECT_EQ(to_srgb8(bright), 255);
}

TEST(AltitudeTints, RiseFromGreenLowlandToSnow) {
  const ColorRamp& ramp = altitude_tints();
  for (std::size_t i = 1; i < ramp.stops.size(); ++i)
    EXPECT_LT(ramp.stops[i - 1].height_m, ramp.stops[i].height_m);
  const glm::vec3 lowland = ramp.at(150);
  EXPECT_GT(lowland.y, lowland.x);
  EXPECT_GT(lowland.y, lowland.z);
  const glm::vec3 snow = ramp.at(8000);
  EXPECT_GT(std::min({snow.x, snow.y, snow.z}), 0.9F);
}

}  // namespace
}  // namespace terrview

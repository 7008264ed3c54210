// Promises of sky/color_table.h.
#include "sky/color_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace terrview {
namespace {

ColorTable three_ramps() {
  ColorTable table;
  table.ramps[0] = {{0, 0}, {1, 1}};
  table.ramps[1] = {{0.25, 0.5}};
  table.ramps[2] = {{0, 0.2}, {0.5, 0.4}, {0.5, 0.8}, {1, 0.8}};
  return table;
}

TEST(ColorTable, HasThreeIndependentLinearRamps) {
  const ColorTable table = three_ramps();
  for (const double address : {0.0, 0.1, 0.3, 0.49, 0.7, 1.0}) {
    const glm::vec3 color = table.at(address);
    EXPECT_FLOAT_EQ(color.r, linear_from_srgb(address));
    EXPECT_FLOAT_EQ(color.g, linear_from_srgb(0.5));
    EXPECT_FLOAT_EQ(color.b, linear_from_srgb(address < 0.5 ? 0.2 + 0.4 * address : 0.8));
  }
}

TEST(ColorTable, JumpsWhereTwoStopsShareAPosition) {
  const ColorTable table = three_ramps();
  EXPECT_NEAR(table.at(0.5 - 1e-9).b, linear_from_srgb(0.4), 1e-6);
  EXPECT_FLOAT_EQ(table.at(0.5).b, linear_from_srgb(0.8));
}

TEST(ColorTable, KeepsItsEndsBeyondThem) {
  const ColorTable table = three_ramps();
  EXPECT_EQ(table.at(-3), table.at(0));
  EXPECT_EQ(table.at(7), table.at(1));
}

TEST(LinearFromSrgb, HasTheValuesOfTheStandard) {
  EXPECT_FLOAT_EQ(linear_from_srgb(0), 0);
  EXPECT_FLOAT_EQ(linear_from_srgb(1), 1);
  EXPECT_NEAR(linear_from_srgb(0.5), 0.2140411, 1e-6);
  EXPECT_NEAR(linear_from_srgb(0.04), 0.04 / 12.92, 1e-7);
}

TEST(BakedTable, IsTheTableToWithinAStep) {
  const ColorTable table = sky_table(0.5);
  const BakedTable baked(table);
  for (double address = -0.2; address < 1.2; address += 0.00137) {
    const glm::vec3 difference = baked.at(static_cast<float>(address)) - table.at(address);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(difference[k], 0, 5e-4) << address;
  }
}

// Share of a normal field's values that the window puts above an address.
double share_above(const ColorTable& table, double address) {
  return std::erfc((address - table.window.middle) / table.window.width / std::sqrt(2.0)) / 2;
}

TEST(SkyTable, GoesFromBlueThroughWhiteToGrey) {
  const ColorTable table = sky_table(0.5);
  const glm::vec3 clear = table.at(table.clear_until / 2);
  const glm::vec3 white = table.at(0.7);
  const glm::vec3 grey = table.at(1);
  EXPECT_GT(clear.b, 2 * clear.r);
  EXPECT_GT(white.r, 0.9F);
  EXPECT_LT(grey.r, 0.3F);
  EXPECT_LT(grey.b, 1.4F * grey.r);
}

TEST(SkyTable, ShowsMoreCloudTheMoreIsAskedFor) {
  const auto covered = [](double clouds) {
    const ColorTable table = sky_table(clouds);
    return share_above(table, (table.clear_until + table.cloud_from) / 2);
  };
  for (int i = 1; i < 19; ++i) EXPECT_LT(covered(i / 20.0), covered((i + 1) / 20.0));
  EXPECT_LT(share_above(sky_table(0), sky_table(0).clear_until), 1e-6);
  EXPECT_GT(share_above(sky_table(1), 0.7), 0.9999);
  for (const double clouds : {0.2, 0.35, 0.5}) EXPECT_NEAR(covered(clouds), clouds, 0.12);
}

TEST(ColorTable, CoversTheSkyBetweenItsTwoBounds) {
  const ColorTable table = sky_table(0.5);
  EXPECT_EQ(table.cover(table.clear_until), 0);
  EXPECT_EQ(table.cover(table.cloud_from), 1);
  EXPECT_NEAR(table.cover((table.clear_until + table.cloud_from) / 2), 0.5, 1e-12);
}

TEST(NamedTable, KnowsItsNamesAndNoOther) {
  for (const char* name : {"sunset", "wood", "marble"}) EXPECT_TRUE(named_table(name)) << name;
  EXPECT_FALSE(named_table("plaid"));
}

}  // namespace
}  // namespace terrview

#include "quantize/nearest_color.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "quantize/color_difference.h"
#include "tests/quantize/colors.h"

namespace terrview {
namespace {

double difference_of(Rgb8 a, Rgb8 b, ColorDifference difference) {
  if (difference == ColorDifference::ciede2000) return ciede2000(a, b);
  const bool rgb = difference == ColorDifference::rgb;
  const glm::dvec3 p = rgb ? glm::dvec3(a) : oklab(a);
  const glm::dvec3 q = rgb ? glm::dvec3(b) : oklab(b);
  return std::pow(p.x - q.x, 2) + std::pow(p.y - q.y, 2) + std::pow(p.z - q.z, 2);
}

TEST(NearestColor, AgreesWithASearchThroughThePalette) {
  for (const ColorDifference difference :
       {ColorDifference::rgb, ColorDifference::oklab, ColorDifference::ciede2000}) {
    for (const std::size_t size : {1U, 2U, 5U, 16U, 100U, 700U}) {
      Palette palette = random_colors(size, 1);
      palette.push_back(palette.front());
      const NearestColor nearest(palette, difference);
      for (const Rgb8 color : random_colors(200, 2)) {
        std::uint32_t expected = 0;
        for (std::uint32_t i = 1; i < palette.size(); ++i)
          if (difference_of(palette[i], color, difference) <
              difference_of(palette[expected], color, difference))
            expected = i;
        EXPECT_EQ(nearest.find(color), expected);
      }
    }
  }
}

TEST(NearestColor, TakesTheFirstOfEquallyNearOnes) {
  const Palette palette{{10, 0, 0}, {0, 10, 0}, {0, 0, 10}, {10, 0, 0}, {0, 10, 0},
                        {0, 0, 10}, {90, 0, 0}, {0, 90, 0}, {0, 0, 90}};
  EXPECT_EQ(NearestColor(palette, ColorDifference::rgb).find({0, 0, 0}), 0U);
  EXPECT_EQ(NearestColor(palette, ColorDifference::rgb).find({0, 9, 9}), 1U);
}

TEST(NearestColor, FindsTheNearestOther) {
  const Palette palette{{0, 0, 0}, {100, 0, 0}, {130, 0, 0}, {255, 0, 0}};
  const NearestColor nearest(palette, ColorDifference::rgb);
  EXPECT_EQ(nearest.nearest_other(0), 1U);
  EXPECT_EQ(nearest.nearest_other(1), 2U);
  EXPECT_EQ(nearest.nearest_other(2), 1U);
  EXPECT_EQ(NearestColor({{1, 2, 3}}, ColorDifference::rgb).nearest_other(0), 0U);
}

}  // namespace
}  // namespace terrview

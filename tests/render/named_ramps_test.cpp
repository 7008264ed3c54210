// Colours that have a name: render/named_ramps.h.
#include "render/named_ramps.h"

#include <gtest/gtest.h>

#include <string>

#include <glm/common.hpp>

namespace terrview {
namespace {

float brightness(const glm::vec3& color) {
  return 0.2126F * color.r + 0.7152F * color.g + 0.0722F * color.b;
}

TEST(NamedRamps, AreFoundByTheirNamesAlone) {
  for (const char* name : {"alpine", "arid", "polar", "grey"}) {
    const ColorRamp* ramp = find_named_ramp(name);
    ASSERT_NE(ramp, nullptr) << name;
    EXPECT_NE(ramp->at(100), ramp->at(4000)) << name;
  }
  EXPECT_EQ(find_named_ramp("Alpine"), nullptr);
  EXPECT_EQ(find_named_ramp("alpine.txt"), nullptr);
  EXPECT_EQ(find_named_ramp(""), nullptr);
}

TEST(NamedRamps, RiseFromStopToStopWithinTheColorsOfASurface) {
  for (const NamedRamp& named : named_ramps()) {
    const auto& stops = named.ramp.stops;
    for (std::size_t i = 0; i < stops.size(); ++i) {
      if (i > 0) {
        EXPECT_LT(stops[i - 1].height_m, stops[i].height_m) << named.name;
      }
      EXPECT_EQ(glm::clamp(stops[i].color, 0.02F, 0.98F), stops[i].color) << named.name;
    }
  }
}

TEST(NamedRamps, ShowTheLandscapeOfTheirName) {
  const auto color = [](const char* name, double height_m) {
    return find_named_ramp(name)->at(height_m);
  };
  EXPECT_GT(color("alpine", 1200).g, color("alpine", 1200).r);  // woods
  EXPECT_GT(brightness(color("alpine", 3500)), 0.7F);           // snow
  EXPECT_GT(color("arid", 1400).r, 2 * color("arid", 1400).b);  // ochre
  EXPECT_GT(brightness(color("polar", 600)), 0.6F);             // ice
  EXPECT_EQ(color("grey", 1234).r, color("grey", 1234).b);
}

}  // namespace
}  // namespace terrview

// One test per promise of render/daylight.h.
#include "render/daylight.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace terrview {
namespace {

constexpr double kRadians = std::numbers::pi / 180;

float brightness(const glm::vec3& color) { return color.x + color.y + color.z; }

TEST(Daylight, GrowsContinuouslyWithTheSun) {
  constexpr double kStep_deg = 0.05;
  Daylight lower = daylight(-30 * kRadians);
  for (double elevation_deg = -30 + kStep_deg; elevation_deg <= 90; elevation_deg += kStep_deg) {
    const Daylight higher = daylight(elevation_deg * kRadians);
    for (const auto& [low, high] :
         {std::pair(lower.sun, higher.sun), std::pair(lower.ambient, higher.ambient),
          std::pair(lower.sky.horizon, higher.sky.horizon),
          std::pair(lower.sky.zenith, higher.sky.zenith)}) {
      EXPECT_GE(brightness(high), brightness(low) - 1e-6F) << elevation_deg;
      EXPECT_LT(brightness(high) - brightness(low), 0.03F) << elevation_deg;
    }
    lower = higher;
  }
}

TEST(Daylight, ReddensTheLowSun) {
  float last = 0;
  for (const double elevation_deg : {90.0, 40.0, 15.0, 5.0, 1.0}) {
    const glm::vec3 sun = daylight(elevation_deg * kRadians).sun;
    EXPECT_GT(sun.x / sun.z, last);
    last = sun.x / sun.z;
  }
}

TEST(Daylight, HasNoSunDeepBelowTheHorizonAndTheSameNightEverAfter) {
  EXPECT_GT(brightness(daylight(-1 * kRadians).sun), 0);
  EXPECT_EQ(brightness(daylight(-3 * kRadians).sun), 0);
  EXPECT_EQ(daylight(-18 * kRadians).ambient, daylight(-60 * kRadians).ambient);
  EXPECT_GT(brightness(daylight(-60 * kRadians).ambient), 0);
}

TEST(Daylight, GlowsTowardsTheSunAtDusk) {
  const Daylight dusk = daylight(-4 * kRadians);
  EXPECT_GT(dusk.sky.sunward->x, 2 * dusk.sky.horizon.x);
  EXPECT_GT(dusk.sky.sunward->x, dusk.sky.sunward->z);
}

}  // namespace
}  // namespace terrview

// Promises of sky/clear_sky.h.
#include "sky/clear_sky.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "sky/sun.h"

namespace terrview {
namespace {

constexpr double kRadians = std::numbers::pi / 180;

glm::dvec3 towards_deg(double azimuth, double elevation) {
  return towards({azimuth * kRadians, elevation * kRadians});
}

ClearSky sky_of(double sun_elevation_deg, SkyModel model = SkyModel::preetham) {
  return ClearSky({model, towards_deg(180, sun_elevation_deg), 2.5});
}

float luminance(const glm::vec3& c) { return 0.2126F * c.r + 0.7152F * c.g + 0.0722F * c.b; }

TEST(PreethamSky, HasTheZenithLuminanceOfThePaper) {
  // The paper's zenith formulas worked by hand (turbidity 2.5, sun 45 degrees from the zenith):
  // chi = (4/9 - 2.5/120) * pi/2 = 0.665406, tan chi = 0.784805.
  const glm::dvec3 zenith = preetham_xyY(2.5, 45 * kRadians, 1, 45 * kRadians);
  EXPECT_NEAR(zenith.z, (4.0453 * 2.5 - 4.9710) * 0.784805 - 0.2155 * 2.5 + 2.4192, 1e-4);
  EXPECT_NEAR(zenith.x, 0.24328, 2e-5);
  EXPECT_NEAR(zenith.y, 0.24758, 2e-5);
}

TEST(PreethamSky, IsBrightestAtTheSunAndBrighterAtTheHorizonThanAcross) {
  const auto luminance_at = [](double elevation_deg, double azimuth_deg) {
    const glm::dvec3 direction = towards_deg(azimuth_deg, elevation_deg);
    const double angle = std::acos(glm::dot(direction, towards_deg(180, 40)));
    return preetham_xyY(2.5, 50 * kRadians, direction.z, angle).z;
  };
  const double at_the_sun = luminance_at(39.9, 180);
  for (double azimuth = 0; azimuth < 360; azimuth += 15)
    for (double elevation = 1; elevation < 90; elevation += 7)
      EXPECT_LE(luminance_at(elevation, azimuth), at_the_sun);
  EXPECT_GT(luminance_at(2, 0), luminance_at(50, 0));
}

TEST(ClearSky, IsTheFormulaWhereTheDayIsHigh) {
  const ClearSky sky = sky_of(50);
  for (const auto& [azimuth, elevation] :
       {std::pair(0, 80), {90, 60}, {300, 35}, {170, 30}, {180, 49}, {20, 12}}) {
    const glm::dvec3 direction = towards_deg(azimuth, elevation);
    const double angle = std::acos(glm::dot(direction, towards_deg(180, 50)));
    const glm::dvec3 xyY = preetham_xyY(2.5, 40 * kRadians, direction.z, angle);
    // Blue over green, undone of the balance, and the compressed luminance.
    const glm::vec3 color = sky.color(direction);
    const float Y = luminance(color * glm::vec3(1.0898F, 0.9851F, 0.7988F));
    EXPECT_NEAR(Y, 1 - std::exp(-1.25 * xyY.z / 15), 2e-3) << azimuth << ' ' << elevation;
  }
}

TEST(ClearSky, IsBlueOverheadAndPalerAtTheHorizon) {
  for (const SkyModel model : {SkyModel::preetham, SkyModel::gradient}) {
    const ClearSky sky = sky_of(45, model);
    const glm::vec3 overhead = sky.color({0, 0, 1});
    const glm::vec3 horizon = sky.color(towards_deg(0, 1));
    EXPECT_GT(overhead.b, 1.5F * overhead.r);
    EXPECT_LT(horizon.b / horizon.r, 0.8F * overhead.b / overhead.r);
    EXPECT_GT(luminance(horizon), luminance(overhead));
  }
}

TEST(ClearSky, NeverGetsBrighterAsTheSunSinksBelowFiveDegrees) {
  for (const double azimuth : {0.0, 90.0, 180.0}) {
    for (const double elevation : {3.0, 30.0, 80.0}) {
      const glm::dvec3 direction = towards_deg(azimuth, elevation);
      float before = 1e9F;
      for (double sun = 0; sun >= -20; sun -= 0.5) {
        const float now = luminance(sky_of(sun).color(direction));
        EXPECT_LE(now, before * 1.0001F) << azimuth << ' ' << elevation << ' ' << sun;
        before = now;
      }
      EXPECT_LT(before, 0.06F);
    }
  }
}

TEST(ClearSky, GlowsWarmOverASunThatHasSet) {
  const ClearSky sky = sky_of(-3);
  const glm::vec3 glow = sky.color(towards_deg(180, 4));
  const glm::vec3 opposite = sky.color(towards_deg(0, 60));
  EXPECT_GT(glow.r, 2 * glow.b);
  EXPECT_GT(opposite.b, opposite.r);
  EXPECT_GT(luminance(glow), 2 * luminance(opposite));
}

TEST(ClearSky, HasNoStepInTimeOrSpace) {
  glm::vec3 before = sky_of(20).color(towards_deg(150, 10));
  for (double sun = 20; sun > -20; sun -= 0.05) {
    const glm::vec3 now = sky_of(sun).color(towards_deg(150, 10));
    EXPECT_LT(glm::distance(now, before), 0.02F) << sun;
    before = now;
  }
  const ClearSky sky = sky_of(1);
  before = sky.color(towards_deg(150, 90));
  for (double elevation = 90; elevation > -5; elevation -= 0.1) {
    const glm::vec3 now = sky.color(towards_deg(150, elevation));
    EXPECT_LT(glm::distance(now, before), 0.02F) << elevation;
    before = now;
  }
}

TEST(ClearSky, TheHorizonsColorIsItsMean) {
  const ClearSky sky = sky_of(30);
  glm::vec3 sum(0);
  for (int azimuth = 0; azimuth < 360; ++azimuth) sum += sky.color(towards_deg(azimuth, 0));
  EXPECT_LT(glm::distance(sky.horizon_color(), sum / 360.0F), 2e-3F);
  EXPECT_LT(glm::distance(sky.color(towards_deg(40, -10)), sky.color(towards_deg(40, 0))), 1e-6F);
}

TEST(Sunlight, ReddensAndDimsWithTheAirItCrosses) {
  const glm::vec3 high = sunlight(60 * kRadians, 2.5);
  const glm::vec3 low = sunlight(5 * kRadians, 2.5);
  EXPECT_GT(high.b, 0.95F);
  EXPECT_LT(low.b, low.r / 2);
  EXPECT_LT(low.r, high.r);
  EXPECT_EQ(sunlight(-7 * kRadians, 2.5).r, 0);
  // Half a degree before sunset much of red and little of blue is left.
  const glm::vec3 last = sunlight(0.5 * kRadians, 2.5);
  EXPECT_GT(last.r, 0.05F);
  EXPECT_LT(last.b, 0.05F);
}

TEST(DuskDimming, FallsSteadilyFromFiveDegrees) {
  EXPECT_EQ(dusk_dimming(30 * kRadians), 1);
  double before = 1;
  for (double sun = 5; sun >= -18; sun -= 0.5) {
    const double now = dusk_dimming(sun * kRadians);
    EXPECT_LE(now, before);
    EXPECT_GT(now, before * 0.8);
    before = now;
  }
  EXPECT_EQ(dusk_dimming(-18 * kRadians), dusk_dimming(-60 * kRadians));
}

}  // namespace
}  // namespace terrview

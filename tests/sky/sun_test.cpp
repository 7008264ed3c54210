// One test per promise of sky/sun.h.
#include "sky/sun.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace terrview {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kRadians = kPi / 180;
constexpr double kDegrees = 180 / kPi;
constexpr double kObliquity_deg = 23.44;

// The sun in degrees, hour angle positive after noon.
struct Degrees {
  double azimuth;
  double elevation;
};

Degrees sun_deg(double latitude_deg, double declination_deg, double hour_angle_deg) {
  const SunPosition sun =
      sun_position(latitude_deg * kRadians, declination_deg * kRadians, hour_angle_deg * kRadians);
  return {sun.azimuth_rad * kDegrees, sun.elevation_rad * kDegrees};
}

TEST(SunPosition, IsOverheadAtTheEquatorAtNoonOfAnEquinox) {
  EXPECT_NEAR(sun_deg(0, 0, 0).elevation, 90, 1e-6);
}

TEST(SunPosition, StandsAtNoonAsHighAsLatitudeAndDeclinationAreApart) {
  for (const double declination : {-kObliquity_deg, 0.0, kObliquity_deg}) {
    for (double latitude = -65; latitude <= 65; latitude += 13) {
      const Degrees sun = sun_deg(latitude, declination, 0);
      EXPECT_NEAR(sun.elevation, 90 - std::abs(latitude - declination), 1e-6);
      const double expected_azimuth = latitude > declination ? 180 : 0;
      EXPECT_NEAR(std::remainder(sun.azimuth - expected_azimuth, 360), 0, 1e-6)
          << latitude << ' ' << declination;
    }
  }
}

TEST(SunPosition, RisesDueEastAndSetsDueWestOnAnEquinox) {
  for (const double latitude : {-60.0, -20.0, 0.0, 35.0, 65.0}) {
    EXPECT_NEAR(sun_deg(latitude, 0, -90).azimuth, 90, 1e-9);
    EXPECT_NEAR(sun_deg(latitude, 0, -90).elevation, 0, 1e-9);
    EXPECT_NEAR(sun_deg(latitude, 0, 90).azimuth, 270, 1e-9);
  }
}

TEST(SunPosition, IsEastBeforeNoonAndItsMirrorImageAfter) {
  for (const double latitude : {-50.0, -10.0, 10.0, 50.0}) {
    for (const double hour_angle : {15.0, 45.0, 75.0}) {
      const Degrees before = sun_deg(latitude, 10, -hour_angle);
      const Degrees after = sun_deg(latitude, 10, hour_angle);
      EXPECT_GT(before.azimuth, 0);
      EXPECT_LT(before.azimuth, 180);
      EXPECT_NEAR(before.azimuth + after.azimuth, 360, 1e-9);
      EXPECT_NEAR(before.elevation, after.elevation, 1e-9);
    }
  }
}

TEST(SunPosition, RisesAtTheHourAndAzimuthOfTheSunriseEquation) {
  for (const double latitude_deg : {-40.0, 20.0, 55.0}) {
    const double latitude = latitude_deg * kRadians;
    const double declination = kObliquity_deg * kRadians;
    const double hour_angle = std::acos(-std::tan(latitude) * std::tan(declination));
    const SunPosition sun = sun_position(latitude, declination, -hour_angle);
    EXPECT_NEAR(sun.elevation_rad, 0, 1e-12);
    EXPECT_NEAR(std::cos(sun.azimuth_rad), std::sin(declination) / std::cos(latitude), 1e-12);
  }
}

TEST(SunPosition, AgreesWithAPublishedExample) {
  // J. Meeus, Astronomical Algorithms, 2nd edition, example 13.b (Venus over Washington); his
  // azimuth counts from the south.
  const Degrees body =
      sun_deg(38 + 55.0 / 60 + 17.0 / 3600, -(6 + 43.0 / 60 + 11.61 / 3600), 64.352133);
  EXPECT_NEAR(body.azimuth, 180 + 68.0337, 1e-4);
  EXPECT_NEAR(body.elevation, 15.1249, 1e-4);
}

TEST(SummerAfternoon, IsThreeHoursAfterNoonOnTheLongestDay) {
  const SunPosition sun = summer_afternoon(48 * kRadians);
  const Degrees expected = sun_deg(48, kObliquity_deg, 45);
  EXPECT_NEAR(sun.azimuth_rad * kDegrees, expected.azimuth, 1e-9);
  EXPECT_NEAR(sun.elevation_rad * kDegrees, expected.elevation, 1e-9);
  EXPECT_GT(expected.azimuth, 180);
}

TEST(SummerAfternoon, IsMirroredInTheSouth) {
  const SunPosition north = summer_afternoon(35 * kRadians);
  const SunPosition south = summer_afternoon(-35 * kRadians);
  EXPECT_NEAR(south.elevation_rad, north.elevation_rad, 1e-12);
  EXPECT_NEAR(std::remainder(kPi - south.azimuth_rad - north.azimuth_rad, 2 * kPi), 0, 1e-12);
}

TEST(Towards, PointsEastNorthUp) {
  const auto expect = [](const SunPosition& sun, const glm::dvec3& direction) {
    EXPECT_LT(glm::distance(towards(sun), direction), 1e-15);
  };
  expect({0, 0}, {0, 1, 0});
  expect({kPi / 2, 0}, {1, 0, 0});
  expect({1, kPi / 2}, {0, 0, 1});
  expect({kPi * 5 / 4, kPi / 6}, {-std::sqrt(3.0 / 8), -std::sqrt(3.0 / 8), 0.5});
}

}  // namespace
}  // namespace terrview

// Fresnel's law: render/fresnel.h.
#include "render/fresnel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace terrview {
namespace {

constexpr double kDegrees = std::numbers::pi / 180;

TEST(Fresnel, MirrorsTwoPercentOfLightThatFallsStraightOntoWater) {
  EXPECT_NEAR(fresnel_reflectance(1, 1.333), 0.0204, 5e-5);
  EXPECT_NEAR(fresnel_reflectance(1, 1.5), 0.04, 1e-12);
}

TEST(Fresnel, MirrorsAllAtAGrazingAngle) {
  EXPECT_EQ(fresnel_reflectance(0, 1.333), 1);
  EXPECT_EQ(fresnel_reflectance(-1e-17, 1.333), 1);
  EXPECT_NEAR(fresnel_reflectance(1e-6, 1.333), 1, 1e-5);
}

TEST(Fresnel, MirrorsOnePolarisationAtBrewstersAngle) {
  for (const double n : {1.333, 1.5, 2.4}) {
    const double one = (n * n - 1) / (n * n + 1);
    EXPECT_NEAR(fresnel_reflectance(std::cos(std::atan(n)), n), one * one / 2, 1e-12) << n;
  }
}

// The same law in the angles of the two rays.
double by_angles(double incident_rad, double index) {
  const double refracted_rad = std::asin(std::sin(incident_rad) / index);
  const double difference = incident_rad - refracted_rad;
  const double sum = incident_rad + refracted_rad;
  const double across = std::sin(difference) / std::sin(sum);
  const double along = std::tan(difference) / std::tan(sum);
  return (across * across + along * along) / 2;
}

TEST(Fresnel, AgreesWithTheLawOfSinesAndTangents) {
  for (double degrees = 1; degrees < 90; degrees += 1)
    for (const double n : {1.1, 1.333, 1.7})
      EXPECT_NEAR(fresnel_reflectance(std::cos(degrees * kDegrees), n),
                  by_angles(degrees * kDegrees, n), 1e-12)
          << degrees << ' ' << n;
}

TEST(Fresnel, IsTheSameFromBothSidesAndTotalBeyondTheCriticalAngle) {
  for (double degrees = 0; degrees < 90; degrees += 5) {
    const double refracted_rad = std::asin(std::sin(degrees * kDegrees) / 1.333);
    EXPECT_NEAR(fresnel_reflectance(std::cos(degrees * kDegrees), 1.333),
                fresnel_reflectance(std::cos(refracted_rad), 1 / 1.333), 1e-9);
  }
  EXPECT_EQ(fresnel_reflectance(std::cos(50 * kDegrees), 1 / 1.333), 1);
}

}  // namespace
}  // namespace terrview

// The promises of terrain/vertical_frame.h, against its formula and against geocentric coordinates,
// both in long double.
#include "terrain/vertical_frame.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include <glm/geometric.hpp>

#include "tests/support/oracle.h"
#include "tests/support/random_scene.h"

namespace terrview {
namespace {

using oracle::Real;

constexpr double kEarthRadius_m = 6371e3;

VerticalFrame earth_frame(double eye_height_m, double refraction = 0.13) {
  return {.eye_height_m = eye_height_m,
          .north_curvature_per_m = 1 / 6.36e6,
          .east_curvature_per_m = 1 / 6.39e6,
          .refraction = refraction};
}

// A whole number over a thousand, so that a counterexample shrinks to something readable.
double milli(int low, int high) { return *rc::gen::inRange(low, high + 1) / 1000.0; }

struct Point {
  VerticalFrame frame;
  glm::dvec2 ground_m;
  double height_m;
};

Point any_point(double reach_km) {
  const double eye_height_m = milli(-400'000, 9'000'000);
  const auto coordinate_m = [&] { return 1000 * reach_km * milli(-700, 700); };
  return {earth_frame(eye_height_m, milli(0, 1000)),
          {coordinate_m(), coordinate_m()},
          milli(-11'000'000, 9'000'000)};
}

RC_GTEST_PROP(VerticalFrame, ItsColumnsAreTheFormula, ()) {
  // Past 640 km, where a series gives way to the functions, too.
  const Point p = any_point(/*reach_km=*/3000);
  const Real expected_m = oracle::z_m(p.frame, p.ground_m.x, p.ground_m.y, p.height_m);
  const double scale_m = std::hypot(p.ground_m.x, p.ground_m.y) + 20'000;
  RC_ASSERT(std::fabs(p.frame.at(p.ground_m).z_m(p.height_m) - expected_m) < 1e-14 * scale_m);
}

// Where the series gives way to the functions, seen from so high that every term of it counts.
TEST(VerticalFrame, ItsSeriesMeetsTheFunctions) {
  const VerticalFrame frame = earth_frame(400'000);
  for (const double s_m : {600e3, 630e3, 635.9e3, 636.1e3, 640e3}) {
    const Real expected_m = oracle::z_m(frame, 0, s_m, 0);
    EXPECT_NEAR(frame.at({0, s_m}).z_m(0), static_cast<double>(expected_m), 1e-9);
  }
}

RC_GTEST_PROP(VerticalFrame, ItsSlopeIsTheDerivative, ()) {
  const Point p = any_point(/*reach_km=*/500);
  const Real h = p.height_m;
  const auto z = [&](Real height_m) {
    return oracle::z_m(p.frame, p.ground_m.x, p.ground_m.y, height_m);
  };
  const Real expected = (z(h + 1) - z(h - 1)) / 2;
  RC_ASSERT(std::fabs(p.frame.at(p.ground_m).slope(p.height_m) - expected) < 1e-10L);
}

RC_GTEST_PROP(VerticalFrame, HeightsComeBackFromZ, ()) {
  const Point p = any_point(/*reach_km=*/500);
  const VerticalFrame::Column column = p.frame.at(p.ground_m);
  RC_ASSERT(std::fabs(column.scene_height_m(column.z_m(p.height_m)) - p.height_m) < 1e-9);
}

RC_GTEST_PROP(VerticalFrame, CeilingsBoundZ, ()) {
  const Point p = any_point(/*reach_km=*/1000);
  const double z_m = p.frame.at(p.ground_m).z_m(p.height_m);
  const double reach_m = std::hypot(p.ground_m.x, p.ground_m.y) * (1 + milli(0, 1000));
  const double ceiling_height_m = p.height_m + milli(0, 1'000'000);
  const double rounding_m = 1e-14 * (reach_m + 20'000);
  RC_ASSERT(p.frame.ceiling_m(ceiling_height_m, reach_m) >= z_m - rounding_m);

  const glm::dvec2 end_m = p.ground_m + glm::dvec2(milli(-10'000, 10'000), milli(-10'000, 10'000));
  const double share = milli(0, 1000);
  const glm::dvec2 between_m = p.ground_m + share * (end_m - p.ground_m);
  RC_ASSERT(p.frame.ceiling_between(ceiling_height_m, p.ground_m, end_m) >=
            p.frame.at(between_m).z_m(p.height_m) - rounding_m);
}

RC_GTEST_PROP(VerticalFrame, SlopesAreWithinTheirBounds, ()) {
  const Point p = any_point(/*reach_km=*/1000);
  // As far as exaggerated relief goes.
  const double scale = milli(1, 1'000'000);
  const double height_m = scale * std::fabs(p.height_m);
  const double below_m = std::min(height_m, 1000 * milli(0, 9'000'000));
  const auto bounds =
      p.frame.slopes(below_m, height_m + below_m, glm::length(p.ground_m) * (1 + milli(0, 1000)));
  const double slope = p.frame.at(p.ground_m).slope(height_m);
  RC_ASSERT(slope >= bounds.least * (1 - 1e-14));
  RC_ASSERT(slope <= bounds.most * (1 + 1e-14));
}

// A point of height h at the arc gamma has the true elevation of its geocentric coordinates.
TEST(VerticalFrame, APointStandsInItsGeocentricDirection) {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    VerticalFrame frame{.eye_height_m = random.uniform(-400, 400'000)};
    frame.north_curvature_per_m = frame.east_curvature_per_m = 1 / kEarthRadius_m;
    const Real s = random.log_uniform(1, 2e6);
    const Real h = random.uniform(-400, 9000);
    const Real gamma = s / kEarthRadius_m;
    const Real across = (kEarthRadius_m + h) * std::sin(gamma);
    const Real up = (kEarthRadius_m + h) * std::cos(gamma) - (kEarthRadius_m + frame.eye_height_m);
    const glm::dvec2 ground_m(0, static_cast<double>(s));
    const Real z = frame.at(ground_m).z_m(static_cast<double>(h));
    EXPECT_NEAR(static_cast<double>(std::atan2(z, s) - std::atan2(up, across)), 0, 1e-13) << i;
  }
}

TEST(VerticalFrame, RefractionLiftsByKOverTwoR) {
  const glm::dvec2 ground_m(0, 50'000);
  const double lift_m =
      earth_frame(300, 0.13).at(ground_m).z_m(1000) - earth_frame(300, 0).at(ground_m).z_m(1000);
  EXPECT_NEAR(lift_m, 0.13 * 50'000.0 * 50'000.0 / (2 * 6.36e6), 1e-9);
}

TEST(VerticalFrame, AFlatEarthOnlySubtractsTheEye) {
  const VerticalFrame frame{.eye_height_m = 1234.5};
  for (const glm::dvec2 ground_m : {glm::dvec2(0, 0), glm::dvec2(3e5, -7e4)}) {
    EXPECT_EQ(frame.at(ground_m).z_m(2000.25), 2000.25 - 1234.5);
    EXPECT_EQ(frame.at(ground_m).scene_height_m(765.75), 2000.25);
    EXPECT_EQ(frame.at(ground_m).slope(2000.25), 1);
  }
  EXPECT_EQ(frame.ceiling_m(2000.25, 1e6), 765.75);
}

TEST(VerticalFrame, UnderTheEyeZIsTheHeightAboveIt) {
  const VerticalFrame frame = earth_frame(1000);
  EXPECT_NEAR(frame.at({0, 0}).z_m(1000), 0, 0);
  EXPECT_NEAR(frame.at({0, 0}).z_m(990), -10 / (1 + 990 / 6.36e6), 1e-13);
  EXPECT_NEAR(frame.at({0, 1e-9}).z_m(990), frame.at({0, 0}).z_m(990), 1e-13);
}

TEST(VerticalFrame, BoundsHowTheHeightOfALineBends) {
  constexpr double kHeightBound_m = 9000;
  Random random(8);
  for (int i = 0; i < 20000; ++i) {
    const VerticalFrame frame{.eye_height_m = random.uniform(-400, 9000),
                              .z_scale = 1,
                              .north_curvature_per_m = random.uniform(0.99, 1.01) / 6.37e6,
                              .east_curvature_per_m = random.uniform(0.99, 1.01) / 6.37e6,
                              .refraction = random.uniform(-1, 0.9)};
    const double reach_m = random.log_uniform(1, 0.095 * 6.37e6);
    ASSERT_TRUE(frame.is_convex(reach_m));
    const double azimuth_rad = random.uniform(0, 6.3);
    const glm::dvec2 along(std::sin(azimuth_rad), std::cos(azimuth_rad));
    const glm::dvec2 start_m(random.uniform(-0.7, 0.7) * reach_m,
                             random.uniform(-0.7, 0.7) * reach_m);
    const double slope = random.sign() * random.log_uniform(1e-4, 20);
    const double z_m = frame.at(start_m).z_m(random.uniform(0, kHeightBound_m));
    const auto height_m = [&](double g_m) {
      return frame.at(start_m + g_m * along).scene_height_m(z_m + slope * g_m);
    };
    const auto s2_over_r = [&](glm::dvec2 p) {
      return p.x * p.x * frame.east_curvature_per_m + p.y * p.y * frame.north_curvature_per_m;
    };
    const double curvature_per_m = s2_over_r(start_m) / glm::dot(start_m, start_m);
    const auto round_height_m = [&](double g_m) {
      const glm::dvec2 p = start_m + g_m * along;
      const double gamma = std::sqrt(s2_over_r(p) * curvature_per_m);
      const double drop_m = frame.at(p).z_m(frame.eye_height_m);
      const double w_m = (z_m + slope * g_m - drop_m) * std::sin(gamma) / gamma;
      return (w_m + frame.eye_height_m) / (1 - curvature_per_m * w_m);
    };
    const double tangent = (round_height_m(1) - round_height_m(-1)) / 2;
    const double length_m = random.log_uniform(1, 3e4);
    if (std::abs(height_m(length_m)) > kHeightBound_m) continue;
    const double above_m = height_m(length_m) - height_m(0) - tangent * length_m;
    const auto bend = frame.bend(kHeightBound_m);
    // The tangent is found to 1e-9 of its length.
    const double rounding_m = 1e-9 * length_m;
    EXPECT_GE(above_m, bend.least_m - rounding_m) << "slope " << slope;
    EXPECT_LE(above_m, bend.most_per_m2 * (1 + 2 * slope * slope) * length_m * length_m -
                           bend.least_m + rounding_m)
        << "slope " << slope << ", " << length_m << " m";
  }
}

}  // namespace
}  // namespace terrview

// One test per promise of terrain/view_transform.h, and of the drop in terrain/vertical_frame.h, on
// a sphere, where everything has a closed form. The ellipsoid's are in tests/ingest.
#include "terrain/view_transform.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <glm/geometric.hpp>

#include "tests/support/instruction_sets.h"

namespace terrview {
namespace {

using Real = long double;

constexpr Real kRadius_m = 6371000;

VerticalFrame sphere(double eye_height_m, double refraction) {
  return {.eye_height_m = eye_height_m,
          .north_curvature_per_m = static_cast<double>(1 / kRadius_m),
          .east_curvature_per_m = static_cast<double>(1 / kRadius_m),
          .refraction = refraction};
}

struct PolarPoint {
  Real azimuth_rad;
  Real arc_rad;
  Real height_m;
};

glm::dvec3 enu(const PolarPoint& p, Real eye_height_m) {
  const Real rho = (kRadius_m + p.height_m) * std::sin(p.arc_rad);
  const Real up = (kRadius_m + p.height_m) * std::cos(p.arc_rad) - (kRadius_m + eye_height_m);
  return {static_cast<double>(rho * std::sin(p.azimuth_rad)),
          static_cast<double>(rho * std::cos(p.azimuth_rad)), static_cast<double>(up)};
}

glm::dvec2 ground(const PolarPoint& p) {
  const Real s = kRadius_m * p.arc_rad;
  return {static_cast<double>(s * std::sin(p.azimuth_rad)),
          static_cast<double>(s * std::cos(p.azimuth_rad))};
}

// The place of a true point, from the geometry of the sphere alone.
PolarPoint place(const glm::dvec3& enu_m, Real eye_height_m) {
  const Real rho = std::hypot(static_cast<Real>(enu_m.x), static_cast<Real>(enu_m.y));
  const Real up = kRadius_m + eye_height_m + enu_m.z;
  return {std::atan2(static_cast<Real>(enu_m.x), static_cast<Real>(enu_m.y)), std::atan2(rho, up),
          std::hypot(rho, up) - kRadius_m};
}

glm::dvec3 view_point(const VerticalFrame& frame, const PolarPoint& p) {
  return {ground(p), frame.at(ground(p)).z_m(static_cast<double>(p.height_m))};
}

std::vector<PolarPoint> random_points(int count, Real furthest_m) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> share(0, 1);
  std::vector<PolarPoint> points;
  for (int i = 0; i < count; ++i)
    points.push_back({2 * std::numbers::pi * share(random), share(random) * furthest_m / kRadius_m,
                      5000.0 * share(random) - 100});
  return points;
}

TEST(ViewTransform, DrawsEveryPostInItsTrueDirection) {
  const double eye_height_m = 1234;
  const VerticalFrame frame = sphere(eye_height_m, 0);
  for (const PolarPoint& p : random_points(1000, 300e3)) {
    const glm::dvec3 drawn = glm::normalize(view_point(frame, p));
    const glm::dvec3 truth = glm::normalize(enu(p, eye_height_m));
    EXPECT_LT(glm::length(glm::cross(drawn, truth)), 1e-12);
  }
}

TEST(ViewTransform, AgreesWithTheColumnsOfHeights) {
  for (const double refraction : {0.0, 0.13}) {
    const VerticalFrame frame = sphere(2000, refraction);
    for (const PolarPoint& p : random_points(1000, 300e3)) {
      EXPECT_LT(glm::distance(from_true_enu(frame, enu(p, 2000)), view_point(frame, p)), 1e-7);
      EXPECT_LT(glm::distance(to_true_enu(frame, view_point(frame, p)), enu(p, 2000)), 1e-7);
    }
  }
}

TEST(ViewTransform, UndoesItself) {
  VerticalFrame frame = sphere(800, 0.13);
  frame.north_curvature_per_m *= 1.005;
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> across_m(-200e3, 200e3);
  std::uniform_real_distribution<double> up_m(-4000, 9000);
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec3 p(across_m(random), across_m(random), up_m(random));
    EXPECT_LT(glm::distance(to_true_enu(frame, from_true_enu(frame, p)), p), 1e-9);
    EXPECT_LT(glm::distance(from_true_enu(frame, to_true_enu(frame, p)), p), 1e-9);
  }
  for (const glm::dvec3 p : {glm::dvec3(0), glm::dvec3(0, 0, -1700), glm::dvec3(1e-9, 0, 3)})
    EXPECT_LT(glm::distance(to_true_enu(frame, from_true_enu(frame, p)), p), 1e-12);
}

TEST(ViewTransform, IsNothingOverAFlatEarth) {
  const VerticalFrame frame{.eye_height_m = 100};
  const glm::dvec3 p(3e4, -2e4, 500);
  EXPECT_EQ(to_true_enu(frame, p), p);
  EXPECT_EQ(from_true_enu(frame, p), p);
  EXPECT_EQ(direction_at(frame, p, glm::dvec3(0.6, 0, 0.8)), glm::dvec3(0.6, 0, 0.8));
  EXPECT_EQ(local_direction(frame, p, glm::dvec3(0.6, 0, 0.8)), glm::dvec3(0.6, 0, 0.8));
}

TEST(ViewTransform, MapsAStraightLineByItsTangent) {
  const double eye_height_m = 1500;
  const VerticalFrame frame = sphere(eye_height_m, 0.13);
  const glm::dvec3 sun = glm::normalize(glm::dvec3(0.8, -0.5, 0.1));
  for (const PolarPoint& p : random_points(200, 300e3)) {
    const glm::dvec3 before = enu(p, eye_height_m) - 50.0 * sun;
    const glm::dvec3 after = enu(p, eye_height_m) + 50.0 * sun;
    const glm::dvec3 expected = glm::normalize(view_point(frame, place(after, eye_height_m)) -
                                               view_point(frame, place(before, eye_height_m)));
    const glm::dvec3 direction = direction_at(frame, view_point(frame, p), sun);
    EXPECT_NEAR(glm::length(direction), 1, 1e-15);
    // Within a kilometre of the eye's plumb line, azimuth turns fast along the chord.
    if (p.arc_rad * kRadius_m > 1000) {
      EXPECT_LT(glm::distance(direction, expected), 1e-7);
    }
  }
}

TEST(ViewTransform, KeepsDirectionsAboveAndBelowTheEye) {
  const VerticalFrame frame = sphere(0, 0.13);
  const glm::dvec3 sun = glm::normalize(glm::dvec3(0.3, 0.4, 0.5));
  EXPECT_LT(glm::distance(direction_at(frame, glm::dvec3(0), sun), sun), 1e-15);
  // A little off the plumb line the same, whatever branch is taken.
  for (const double aside_m : {1e-6, 0.5e-3, 2e-3, 1.0}) {
    const glm::dvec3 p(aside_m, -aside_m, -3000);
    EXPECT_LT(glm::distance(direction_at(frame, p, sun),
                            direction_at(frame, glm::dvec3(0, 0, -3000), sun)),
              1e-6);
  }
}

TEST(ViewTransform, TurnsManyDirectionsAsItTurnsOne) {
  const VerticalFrame ellipsoid{.eye_height_m = 2500,
                                .north_curvature_per_m = 1 / 6.36e6,
                                .east_curvature_per_m = 1 / 6.39e6,
                                .refraction = 0.13};
  const glm::dvec3 sun = glm::normalize(glm::dvec3(-0.7, 0.2, 0.4));
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> share(-1, 1);
  // Below the eye and beside its plumb line, and from metres to beyond the series.
  std::vector<glm::dvec3> points{{0, 0, 0}, {0, 0, -900}, {5e-4, 0, 20}, {0, -2e-3, 20}};
  for (int i = 0; i < 999; ++i) {
    const double reach_m = std::pow(10, 3.2 + 3.4 * share(random));
    const double x_m = reach_m * share(random);
    const double y_m = reach_m * share(random);
    points.emplace_back(x_m, y_m, 4e3 * share(random));
  }
  for (const VerticalFrame& frame : {ellipsoid, VerticalFrame{.eye_height_m = 100}}) {
    std::vector<glm::dvec3> directions(points.size());
    under_every_instruction_set([&] {
      std::fill(directions.begin(), directions.end(), glm::dvec3(0));
      directions_at(frame, points, sun, directions);
      for (std::size_t i = 0; i < points.size(); ++i)
        ASSERT_EQ(directions[i], direction_at(frame, points[i], sun)) << points[i].x;
    });
  }
}

TEST(ViewTransform, TellsTheSunsHeightAtTheHit) {
  const VerticalFrame frame = sphere(0, 0.13);
  // A sun on the eye's horizon in the east is up by the arc in the east, down by it in the west.
  const Real arc = 100e3L / kRadius_m;
  const double sine = static_cast<double>(std::sin(arc));
  const glm::dvec3 east(1, 0, 0);
  EXPECT_NEAR(local_direction(frame, {100e3, 0, 0}, east).z, sine, 1e-15);
  EXPECT_NEAR(local_direction(frame, {-100e3, 0, 0}, east).z, -sine, 1e-15);
  EXPECT_NEAR(local_direction(frame, {0, 100e3, 0}, east).z, 0, 1e-15);
  EXPECT_NEAR(local_direction(frame, {0, 100e3, 0}, east).x, 1, 1e-15);
  EXPECT_NEAR(glm::length(local_direction(frame, {3e4, 7e4, 0}, east)), 1, 1e-15);
}

TEST(VerticalFrame, DropsAsTheTextbooksSay) {
  const VerticalFrame frame = sphere(0, 0.13);
  struct Row {
    double distance_m;
    double drop_m;
  };
  for (const Row& row : {Row{10e3, 6.83}, Row{35e3, 83.64}, Row{100e3, 682.78}})
    EXPECT_NEAR(-frame.at({row.distance_m, 0}).z_m(0), row.drop_m, 0.1) << row.distance_m;
}

// The highest apparent elevation of the sea, by bisection of its slope.
double sea_horizon_dip_rad(const VerticalFrame& frame) {
  const auto elevation = [&](double s_m) { return frame.at({0, s_m}).z_m(0) / s_m; };
  double low_m = 1;
  double high_m = 1e6;
  for (int i = 0; i < 200; ++i) {
    const double third_m = (high_m - low_m) / 3;
    if (elevation(low_m + third_m) < elevation(high_m - third_m))
      low_m += third_m;
    else
      high_m -= third_m;
  }
  return -std::atan(elevation(low_m));
}

TEST(VerticalFrame, DipsTheSeaHorizonByItsClosedForm) {
  for (const double height_m : {100.0, 1000.0, 10000.0}) {
    const Real true_dip = std::acos(kRadius_m / (kRadius_m + height_m));
    EXPECT_NEAR(sea_horizon_dip_rad(sphere(height_m, 0)), static_cast<double>(true_dip), 1e-9);
    // With refraction, that of a sphere of radius R / (1 - k).
    const Real widened_m = kRadius_m / (1 - 0.13L);
    const Real apparent_dip = std::acos(widened_m / (widened_m + height_m));
    EXPECT_NEAR(sea_horizon_dip_rad(sphere(height_m, 0.13)), static_cast<double>(apparent_dip),
                1e-3 * static_cast<double>(apparent_dip));
  }
}

}  // namespace
}  // namespace terrview

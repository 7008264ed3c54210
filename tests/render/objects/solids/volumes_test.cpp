// Volumes of composed solids, measured by what lines have within them, against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "tests/render/objects/solids/body.h"

namespace terrview {
namespace {

constexpr double kPi = std::numbers::pi;

// The mean of the lengths within, of upright lines through random points of a square, times its
// area: within five standard errors of `expected_m3`, of which `share` at most one is.
void expect_volume(const Body& body, double half_m, double expected_m3, double share) {
  std::mt19937_64 engine(1);
  constexpr int kLines = 200000;
  double sum = 0;
  double squares = 0;
  for (int i = 0; i < kLines; ++i) {
    const Line line{{real(engine, -half_m, half_m), real(engine, -half_m, half_m), 100},
                    {0, 0, -1}};
    double within_m = 0;
    for (const Crossing& c : crossings_of(*body.solid, line)) within_m += c.enters ? -c.t : c.t;
    sum += within_m;
    squares += within_m * within_m;
  }
  const double mean_m = sum / kLines;
  const double area_m2 = 4 * half_m * half_m;
  const double error_m3 = area_m2 * std::sqrt((squares / kLines - mean_m * mean_m) / kLines);
  EXPECT_LT(error_m3, share * expected_m3);
  EXPECT_NEAR(area_m2 * mean_m, expected_m3, 5 * error_m3);
}

// An upright cylinder through the origin, laid along an axis.
Body pillar(double radius_m, const glm::dvec3& turn_axis) {
  const Body upright = transformed(frustum_body(radius_m, radius_m, 8), shift({0, 0, -4}));
  return transformed(upright, glm::rotate(glm::dmat4(1), kPi / 2, turn_axis));
}

TEST(SolidVolume, OfALensOfTwoSpheres) {
  const Body lens =
      composed(CsgOperator::intersect, transformed(sphere_body(1), shift({0.4, 0, 0})),
               transformed(sphere_body(1), shift({-0.6, 0, 0})));
  const double d = 1;
  expect_volume(lens, 1, kPi / 12 * (4 + d) * (2 - d) * (2 - d), 0.01);
}

TEST(SolidVolume, OfTwoAndThreeCrossedCylinders) {
  const Body x = pillar(1, {0, 1, 0});
  const Body y = pillar(1, {1, 0, 0});
  const Body two = composed(CsgOperator::intersect, x, y);
  expect_volume(two, 1.1, 16.0 / 3, 0.01);
  const Body z = transformed(frustum_body(1, 1, 8), shift({0, 0, -4}));
  expect_volume(composed(CsgOperator::intersect, two, z), 1.1, 8 * (2 - std::sqrt(2)), 0.01);
}

TEST(SolidVolume, OfABoxWithAHole) {
  const Body box = box_body({{-1, -1, -1}, {1, 1, 1}});
  const Body drilled = composed(CsgOperator::subtract, box, pillar(0.5, {1, 0, 0}));
  expect_volume(drilled, 1.1, 8 - 2 * kPi / 4, 0.01);
}

// What a drill leaves of a ball depends on the length of the hole alone.
TEST(SolidVolume, OfANapkinRing) {
  const Body ring = composed(CsgOperator::subtract, sphere_body(1.3), pillar(0.5, {1, 1, 0}));
  const double hole_m = 2 * std::sqrt(1.3 * 1.3 - 0.5 * 0.5);
  expect_volume(ring, 1.4, kPi * hole_m * hole_m * hole_m / 6, 0.01);
}

TEST(SolidVolume, OfATorusATruncatedConeAndAStar) {
  std::mt19937_64 engine(2);
  expect_volume(transformed(torus_body(1, 0.3), turn(engine)), 1.4, 2 * kPi * kPi * 0.09, 0.01);
  const double cone_m3 = kPi * 2 / 3 * (1 + 0.5 + 0.25);
  expect_volume(transformed(frustum_body(1, 0.5, 2), turn(engine)), 2.5, cone_m3, 0.01);
  // Ten triangles, of sides 1 and 0.4 and 36 degrees between.
  const double star_m2 = 10 * 0.5 * 0.4 * std::sin(kPi / 5);
  expect_volume(transformed(star_body(5, 1, 0.5), turn(engine)), 1.2, star_m2 * 0.5, 0.01);
}

TEST(SolidVolume, OfASumIsThatOfItsSidesLessWhatTheyShare) {
  std::mt19937_64 engine(3);
  const Body ball = sphere_body(1);
  const Body corner = transformed(box_body({{0, 0, 0}, {2, 2, 2}}), glm::dmat4(1));
  expect_volume(composed(CsgOperator::add, ball, corner), 2.1, 8 + kPi * 4 / 3 * 7 / 8, 0.01);
}

TEST(SolidVolume, ScalesWithTheTransform) {
  glm::dmat4 m(1);
  m[0][0] = 2;
  m[1][0] = 0.7;  // sheared
  m[2][2] = 0.5;
  expect_volume(transformed(sphere_body(1), m), 2.8, kPi * 4 / 3, 0.01);
}

}  // namespace
}  // namespace terrview

// Promises of the primitive solids, against what they are point by point, in long double, and
// closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "render/objects/solids/box_solid.h"
#include "render/objects/solids/frustum.h"
#include "render/objects/solids/half_space_solid.h"
#include "render/objects/solids/prism_solid.h"
#include "render/objects/solids/sphere_solid.h"
#include "render/objects/solids/torus.h"
#include "render/objects/solids/transformed.h"
#include "terrain/error.h"
#include "tests/render/objects/solids/body.h"

namespace terrview {
namespace {

void expect_no_fault(const Body& body, const Line& line, std::mt19937_64& engine,
                     const std::string& what) {
  ASSERT_EQ(fault_of(body, line, engine), "") << what;
}

TEST(PrimitiveSolids, AreCrossedWhereTheyAreToWithinTheirError) {
  std::mt19937_64 engine(1);
  for (int round = 0; round < 300; ++round) {
    const std::vector<Body> bodies = primitives(engine);
    for (std::size_t i = 0; i < bodies.size(); ++i)
      for (int k = 0; k < 20; ++k)
        expect_no_fault(bodies[i], line_through(engine, {0, 0, 0}, bodies[i].size_m, 1e6), engine,
                        "primitive " + std::to_string(i));
  }
}

TEST(PrimitiveSolids, AreCrossedWhereTheyAreWhereverTheyStand) {
  std::mt19937_64 engine(2);
  for (int round = 0; round < 300; ++round) {
    const std::vector<Body> bodies = primitives(engine);
    const glm::dvec3 at_m = std::pow(10.0, real(engine, 0, 6)) * direction(engine);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const Body body =
          transformed(transformed(bodies[i], turn(engine, true)), shift(at_m) * turn(engine, true));
      for (int k = 0; k < 10; ++k)
        expect_no_fault(body, line_through(engine, at_m, bodies[i].size_m, 1e6), engine,
                        "primitive " + std::to_string(i));
    }
  }
}

TEST(PrimitiveSolids, AreCrossedWhereTheyAreHoweverUnequallyStretched) {
  std::mt19937_64 engine(5);
  for (int round = 0; round < 300; ++round) {
    const auto scale = [&] { return std::pow(10.0, real(engine, -3, 3)); };
    const glm::dmat4 stretch = glm::scale(glm::dmat4(1), {scale(), scale(), scale()});
    for (const Body& primitive : primitives(engine)) {
      const Body body = transformed(primitive, turn(engine) * stretch * turn(engine));
      for (int k = 0; k < 10; ++k)
        expect_no_fault(body, line_through(engine, {0, 0, 0}, body.size_m, 1e6), engine,
                        "round " + std::to_string(round));
    }
  }
}

TEST(PrimitiveSolids, ThinOnesAreCrossedToWithinTheirError) {
  std::mt19937_64 engine(3);
  for (const Body& body :
       {torus_body(100, 0.001), torus_body(1, 0.999999), frustum_body(0.01, 0.01, 1000),
        frustum_body(0.01, 0, 1000), frustum_body(1000, 999.99, 0.01),
        box_body({{-1000, -1000, 0}, {1000, 1000, 0.001}})}) {
    for (int k = 0; k < 20000; ++k) {
      const Line line = line_through(engine, {0, 0, 0}, body.size_m, 1e4);
      expect_no_fault(body, line, engine, std::to_string(body.size_m));
    }
  }
}

// Of lines straight down on squares of side 2 * half_m.
double disc_share(const Solid& solid, double half_m, int lines) {
  int met = 0;
  for (int i = 0; i < lines; ++i)
    for (int k = 0; k < lines; ++k) {
      const double x = half_m * (2 * (i + 0.5) / lines - 1);
      const double y = half_m * (2 * (k + 0.5) / lines - 1);
      if (!crossings_of(solid, {{x, y, 1e4}, {0, 0, -1}}).empty()) ++met;
    }
  return static_cast<double>(met) / (static_cast<double>(lines) * lines);
}

TEST(PrimitiveSolids, SilhouettesFromAboveAreDiscs) {
  constexpr double kPi = std::numbers::pi;
  EXPECT_NEAR(disc_share(SphereSolid(1), 1, 400), kPi / 4, 1e-3);
  EXPECT_NEAR(disc_share(Frustum({1, 1, 3}), 1, 400), kPi / 4, 1e-3);
  EXPECT_NEAR(disc_share(Frustum({1, 0, 3}), 1, 400), kPi / 4, 1e-3);
  EXPECT_NEAR(disc_share(Torus({0.75, 0.25}), 1, 400), kPi * (1 - 0.25) / 4, 1e-3);
}

// Each line beside the silhouette's edge by a billionth of its radius.
TEST(PrimitiveSolids, SilhouettesEndWhereTheClosedFormSays) {
  const SphereSolid sphere(2);
  const Frustum cylinder({2, 2, 3});
  const Torus torus({1.5, 0.5});
  const Frustum cone({2, 0, 3});
  for (int i = 0; i < 1000; ++i) {
    const double angle = 2 * std::numbers::pi * i / 1000;
    const glm::dvec3 out(std::cos(angle), std::sin(angle), 0);
    for (const bool inside : {true, false}) {
      const glm::dvec3 edge = (inside ? 1 - 1e-9 : 1 + 1e-9) * out;
      const glm::dvec3 up(0, 0, 1);
      EXPECT_EQ(crossings_of(sphere, {2.0 * edge + up * 9.0, -up}).size(), inside ? 2U : 0U);
      EXPECT_EQ(crossings_of(cylinder, {2.0 * edge + up * 9.0, -up}).size(), inside ? 2U : 0U);
      EXPECT_EQ(crossings_of(torus, {2.0 * edge + up * 9.0, -up}).size(), inside ? 2U : 0U);
      EXPECT_EQ(crossings_of(torus, {edge + up * 9.0, -up}).size(), inside ? 0U : 2U);
      // Level lines beside the outline of the cone at half its height.
      const glm::dvec3 aside(-out.y, out.x, 0);
      EXPECT_EQ(crossings_of(cone, {edge + up * 1.5 + aside * 7.0, aside}).size(),
                inside ? 2U : 0U);
    }
  }
}

TEST(PrimitiveSolids, ATorusIsMetFourTimesThroughBothSidesOfItsRing) {
  const auto crossings = crossings_of(Torus({3, 1}), {{-10, 0, 0}, {2, 0, 0}});
  ASSERT_EQ(crossings.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    const double x_m[] = {-4, -2, 2, 4};
    EXPECT_DOUBLE_EQ(crossings[i].t, (10 + x_m[i]) / 2);
    EXPECT_NEAR(glm::distance(crossings[i].normal, {i % 2 == 0 ? -1 : 1, 0, 0}), 0, 1e-15);
  }
}

TEST(PrimitiveSolids, AreClosedAlongTheirFacesAndEdges) {
  const BoxSolid box({{0, 0, 0}, {1, 2, 3}});
  EXPECT_EQ(crossings_of(box, {{0, 0, -5}, {0, 0, 1}}).size(), 2U);   // along an edge
  EXPECT_EQ(crossings_of(box, {{1, 1, -5}, {0, 0, 1}}).size(), 2U);   // in a face
  EXPECT_EQ(crossings_of(box, {{-1, 1, 3}, {1, 0, 0}}).size(), 2U);   // in its top
  EXPECT_EQ(crossings_of(box, {{-1, -1, 0}, {1, 2, 3}}).size(), 0U);  // past
  const Frustum cylinder({1, 1, 2});
  EXPECT_EQ(crossings_of(cylinder, {{-5, 0, 2}, {1, 0, 0}}).size(), 2U);  // in its top
  EXPECT_EQ(crossings_of(cylinder, {{1, 0, -5}, {0, 0, 1}}).size(), 2U);  // along its side
  const Frustum cone({1, 0, 1});
  EXPECT_EQ(crossings_of(cone, {{-1, 0, 0}, {1, 0, 1}}).size(), 2U);    // along its side
  EXPECT_EQ(crossings_of(cone, {{-2, 0, 0}, {1, 0, 1}}).size(), 0U);    // beside it
  EXPECT_EQ(crossings_of(cone, {{-0.5, 0, 0}, {1, 0, 1}}).size(), 2U);  // along it, inside
  EXPECT_EQ(crossings_of(cone, {{0, 0, 9}, {0, 0, -1}}).size(), 2U);    // through its top
  const auto base = crossings_of(HalfSpaceSolid({{0, 0, 2}, 6}), {{0, 0, 3}, {1, 0, 0}});
  ASSERT_EQ(base.size(), 2U);
  EXPECT_TRUE(std::isinf(base[0].t));
  EXPECT_TRUE(std::isinf(base[1].t));
}

// Along a slit of no width.
TEST(PrimitiveSolids, APrismGoesOnWhereItsPolygonTouchesItself) {
  const std::vector<Polygon::Ring> slit{
      {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 0.125}, {1, 1}, {0, 1}}};
  const PrismSolid prism(Polygon(slit), 1);
  const auto crossings = crossings_of(prism, {{-3, 0.25, 0.5}, {1, 0, 0}});
  ASSERT_EQ(crossings.size(), 2U);
  EXPECT_EQ(crossings[0].t, 3);
  EXPECT_EQ(crossings[1].t, 5);
}

TEST(PrimitiveSolids, BoundsContainTheirCrossings) {
  std::mt19937_64 engine(4);
  for (int round = 0; round < 100; ++round)
    for (const Body& primitive : primitives(engine)) {
      const Body body = transformed(primitive, shift({5, 6, 7}) * turn(engine, true));
      const Box bounds = body.solid->bounds();
      for (int k = 0; k < 20; ++k) {
        const Line line = line_through(engine, {5, 6, 7}, 2, 100);
        for (const Crossing& c : crossings_of(*body.solid, line)) {
          if (std::isinf(c.t)) continue;
          const glm::dvec3 at_m = line.origin_m + c.t * line.direction;
          EXPECT_TRUE(glm::all(glm::greaterThan(at_m, bounds.lowest_m - 1e-9)));
          EXPECT_TRUE(glm::all(glm::lessThan(at_m, bounds.highest_m + 1e-9)));
        }
      }
    }
}

TEST(PrimitiveSolids, RefuseSizesThatMakeNoBody) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  for (const double bad : {0.0, -1.0, nan, inf}) {
    EXPECT_THROW(SphereSolid{bad}, InputError);
    EXPECT_THROW(BoxSolid({{0, 0, 0}, {1, 1, bad}}), InputError);
    EXPECT_THROW(Frustum({1, 1, bad}), InputError);
    EXPECT_THROW(Torus({1, bad}), InputError);
    EXPECT_THROW(HalfSpaceSolid({{0, 0, std::max(bad, 0.0)}, bad}), InputError);
    const std::vector<Polygon::Ring> square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    EXPECT_THROW(PrismSolid(Polygon(square), bad), InputError);
  }
  EXPECT_THROW(Frustum({0, 0, 1}), InputError);
  EXPECT_THROW(Frustum({-1, 1, 1}), InputError);
  EXPECT_THROW(Torus({1, 1}), InputError);
  const std::vector<Polygon::Ring> flat{{{0, 0}, {1, 0}, {2, 0}}};
  EXPECT_THROW(PrismSolid(Polygon(flat), 1), InputError);
  EXPECT_THROW(PrismSolid(Polygon({}), 1), InputError);
}

TEST(Transformed, RefusesWhatCannotBeInverted) {
  const auto sphere = std::make_shared<SphereSolid>(1);
  glm::dmat4 flat(1);
  flat[2][2] = 0;
  EXPECT_THROW(Transformed(sphere, flat), InputError);
  glm::dmat4 projective(1);
  projective[0][3] = 0.5;
  EXPECT_THROW(Transformed(sphere, projective), InputError);
  EXPECT_THROW(Transformed(sphere, shift({0, std::nan(""), 0})), InputError);
  glm::dmat4 tiny(1e-6);
  tiny[3][3] = 1;
  EXPECT_NO_THROW(Transformed(sphere, tiny));
}

TEST(Transformed, ANormalStandsOnTheStretchedSurface) {
  glm::dmat4 stretch(1);
  stretch[0][0] = 2;
  const Transformed ellipsoid(std::make_shared<SphereSolid>(1), stretch);
  const double c = std::sqrt(0.5);
  const auto crossings = crossings_of(ellipsoid, {{2 * c, 0, 5}, {0, 0, -1}});
  ASSERT_EQ(crossings.size(), 2U);
  EXPECT_NEAR(crossings[0].t, 5 - c, 1e-15);
  // The gradient of x^2 / 4 + z^2.
  const glm::dvec3 expected = glm::normalize(glm::dvec3(2 * c / 4, 0, c));
  EXPECT_NEAR(glm::distance(crossings[0].normal, expected), 0, 1e-15);
}

}  // namespace
}  // namespace terrview

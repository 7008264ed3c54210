// Coincident faces show no speckle: the promise of render/objects/solids/csg.h on bodies whose
// common surfaces are computed by different ways, so that they agree but for rounding.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include "tests/render/objects/solids/body.h"

namespace terrview {
namespace {

// The same body by another way: turned, stretched and moved up to 1000 km, and back.
Body rewritten(const Body& body, std::mt19937_64& engine) {
  const glm::dvec3 by_m = std::pow(10.0, real(engine, -1, 6)) * direction(engine);
  const glm::dmat4 there = shift(by_m) * turn(engine, true);
  return transformed(transformed(body, there), glm::inverse(there));
}

struct Placed {
  Body a;
  Body b;
  glm::dvec3 at_m;
};

// Two bodies put in one place up to 1000 km away, each after a way of its own.
Placed placed(const Body& a, const Body& b, std::mt19937_64& engine) {
  const glm::dvec3 at_m = std::pow(10.0, real(engine, -1, 6)) * direction(engine);
  const glm::dmat4 to_place = shift(at_m) * turn(engine);
  return {transformed(a, to_place), transformed(rewritten(b, engine), to_place), at_m};
}

std::size_t count(CsgOperator op, const Placed& bodies, const Line& line) {
  return crossings_of(*composed(op, bodies.a, bodies.b).solid, line).size();
}

// Where a line only scratches a body, rounding may tell whether it meets it at all.
bool scratches(const Solid& solid, const Line& line) {
  const auto crossings = crossings_of(solid, line);
  for (std::size_t i = 1; i < crossings.size(); ++i)
    if (crossings[i].t - crossings[i - 1].t < 8 * (crossings[i].error + crossings[i - 1].error))
      return true;
  return false;
}

TEST(CoincidentSurfaces, ABodyLessItselfIsNothingAndWithItselfIsItself) {
  std::mt19937_64 engine(1);
  for (int round = 0; round < 200; ++round)
    for (const Body& primitive : primitives(engine)) {
      const Body body = transformed(primitive, turn(engine, true));
      const Placed same = placed(body, body, engine);
      for (int i = 0; i < 20; ++i) {
        const Line line = line_through(engine, same.at_m, body.size_m, 1e6);
        if (scratches(*same.a.solid, line) || scratches(*same.b.solid, line)) continue;
        const auto alone = crossings_of(*same.a.solid, line);
        ASSERT_EQ(count(CsgOperator::subtract, same, line), 0U);
        for (const CsgOperator op : {CsgOperator::add, CsgOperator::intersect}) {
          const auto both = crossings_of(*composed(op, same.a, same.b).solid, line);
          ASSERT_EQ(both.size(), alone.size());
          for (std::size_t k = 0; k < both.size(); ++k) {
            EXPECT_EQ(both[k].t, alone[k].t);
            EXPECT_EQ(both[k].part, 0);
          }
        }
      }
    }
}

// No line lies nearly in a face: with A's own numbers, nothing else is left to chance.
TEST(CoincidentSurfaces, ABodyLessItselfIsNothingForEveryLine) {
  std::mt19937_64 engine(2);
  for (int round = 0; round < 100; ++round)
    for (const Body& body : primitives(engine)) {
      const Body none = composed(CsgOperator::subtract, body, body);
      const Body same = composed(CsgOperator::add, body, body);
      for (int i = 0; i < 50; ++i) {
        const Line line = line_through(engine, {0, 0, 0}, body.size_m, 1e6);
        EXPECT_TRUE(crossings_of(*none.solid, line).empty());
        EXPECT_EQ(crossings_of(*same.solid, line).size(), crossings_of(*body.solid, line).size());
      }
    }
}

TEST(CoincidentSurfaces, TouchingBoxesHaveNoInnerFace) {
  std::mt19937_64 engine(3);
  const Body left = box_body({{-1, -1, -1}, {0, 1, 1}});
  const Body right = box_body({{0, -1, -1}, {1.5, 1, 1}});
  const Body whole = box_body({{-1, -1, -1}, {1.5, 1, 1}});
  for (int round = 0; round < 500; ++round) {
    const Placed halves = placed(left, right, engine);
    for (int i = 0; i < 100; ++i) {
      const Line line = line_through(engine, halves.at_m, 1.5, 1e6);
      if (scratches(*halves.a.solid, line) || scratches(*halves.b.solid, line)) continue;
      const std::size_t each =
          crossings_of(*halves.a.solid, line).size() + crossings_of(*halves.b.solid, line).size();
      ASSERT_EQ(count(CsgOperator::add, halves, line), each > 0 ? 2U : 0U);
      ASSERT_EQ(count(CsgOperator::intersect, halves, line), 0U);
      ASSERT_EQ(count(CsgOperator::subtract, halves, line),
                crossings_of(*halves.a.solid, line).size());
    }
    const Placed cut = placed(whole, right, engine);
    for (int i = 0; i < 100; ++i) {
      const Line line = line_through(engine, cut.at_m, 1.5, 1e6);
      const auto rest = crossings_of(*composed(CsgOperator::subtract, cut.a, cut.b).solid, line);
      ASSERT_LE(rest.size(), 2U);
      if (rest.empty() || scratches(*cut.b.solid, line)) continue;
      // What is left is a cube of side 2 or less across, not a skin.
      const double length_m = (rest[1].t - rest[0].t) * glm::length(line.direction);
      const bool is_corner = scratches(*composed(CsgOperator::subtract, cut.a, cut.b).solid, line);
      EXPECT_TRUE(is_corner || length_m > 1e-9) << length_m;
    }
  }
}

// Where rounding may choose between the two faces of an edge.
TEST(CoincidentSurfaces, ABoxLessItselfIsNothingAtItsEdges) {
  std::mt19937_64 engine(5);
  const Box box{{-1, -2, -3}, {3, 2, 1}};
  for (int round = 0; round < 2000; ++round) {
    const glm::dmat4 to_place = shift(direction(engine)) * turn(engine);
    const Body a = transformed(box_body(box), to_place);
    const glm::dmat4 there = turn(engine);
    const Body again =
        transformed(transformed(transformed(box_body(box), there), glm::inverse(there)), to_place);
    // Through a point of an edge and one inside.
    const glm::dvec4 edge(3, real(engine, -2, 2), 1, 1);
    const glm::dvec4 inside(real(engine, -0.9, 2.9), real(engine, -1.9, 1.9),
                            real(engine, -2.9, 0.9), 1);
    const glm::dvec3 from_m(to_place * edge);
    const glm::dvec3 way(to_place * (inside - edge));
    const Line line{from_m - 10.0 * way, way};
    EXPECT_TRUE(crossings_of(*composed(CsgOperator::subtract, a, again).solid, line).empty());
  }
}

// A hole drilled from face to face is open at both ends.
TEST(CoincidentSurfaces, AHoleThatEndsInAFaceIsOpen) {
  std::mt19937_64 engine(4);
  const Body plate = box_body({{-2, -2, 0}, {2, 2, 0.5}});
  const Body drill = frustum_body(1, 1, 0.5);
  int through = 0;
  for (int round = 0; round < 500; ++round) {
    const Placed bodies = placed(plate, drill, engine);
    const Body holed = composed(CsgOperator::subtract, bodies.a, bodies.b);
    for (int i = 0; i < 40; ++i) {
      const Line line = line_through(engine, bodies.at_m, 0.05, 1e3);
      const auto drilled = crossings_of(*bodies.b.solid, line);
      const auto around = crossings_of(*bodies.a.solid, line);
      // Both ends in the plate's faces.
      const auto same = [](const Crossing& a, const Crossing& b) {
        return std::abs(a.t - b.t) <= a.error + b.error;
      };
      if (drilled.size() != 2 || around.size() != 2) continue;
      if (!same(drilled[0], around[0]) || !same(drilled[1], around[1])) continue;
      EXPECT_TRUE(crossings_of(*holed.solid, line).empty());
      ++through;
    }
  }
  EXPECT_GT(through, 5000);
}

}  // namespace
}  // namespace terrview

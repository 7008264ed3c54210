// Promises of render/objects/solids/csg.h.
#include "render/objects/solids/csg.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include <glm/geometric.hpp>

#include "render/objects/solids/box_solid.h"
#include "render/objects/solids/sphere_solid.h"
#include "render/objects/solids/transformed.h"
#include "tests/render/objects/solids/body.h"

namespace terrview {
namespace {

constexpr CsgOperator kOperators[] = {CsgOperator::add, CsgOperator::intersect,
                                      CsgOperator::subtract};

// Crossed where it is told, whatever the line; counts how often it is asked.
class Told final : public Solid {
 public:
  explicit Told(std::vector<double> ts) : ts_(std::move(ts)) {}

  Box bounds() const override { return {{0, 0, 0}, {1, 1, 1}}; }
  void append_crossings(const Line& /*line*/, Crossings& crossings) const override {
    ++asked_;
    for (std::size_t i = 0; i < ts_.size(); ++i)
      crossings.push_back({ts_[i], 1e-9, {i % 2 == 0 ? -1 : 1, 0, 0}, 0, i % 2 == 0});
  }
  int asked() const { return asked_; }

 private:
  std::vector<double> ts_;
  mutable int asked_ = 0;
};

std::vector<Crossing> told(CsgOperator op, std::vector<double> left, std::vector<double> right) {
  const CsgSolid solid(op, std::make_shared<Told>(std::move(left)),
                       std::make_shared<Told>(std::move(right)));
  return crossings_of(solid, {{0, 0, 0}, {1, 0, 0}});
}

TEST(CsgTable, IsThatOfTheOperators) {
  EXPECT_TRUE(is_inside(CsgOperator::add, true, true));
  EXPECT_TRUE(is_inside(CsgOperator::add, true, false));
  EXPECT_TRUE(is_inside(CsgOperator::add, false, true));
  EXPECT_FALSE(is_inside(CsgOperator::add, false, false));
  EXPECT_TRUE(is_inside(CsgOperator::intersect, true, true));
  EXPECT_FALSE(is_inside(CsgOperator::intersect, true, false));
  EXPECT_FALSE(is_inside(CsgOperator::intersect, false, true));
  EXPECT_FALSE(is_inside(CsgOperator::intersect, false, false));
  EXPECT_FALSE(is_inside(CsgOperator::subtract, true, true));
  EXPECT_TRUE(is_inside(CsgOperator::subtract, true, false));
  EXPECT_FALSE(is_inside(CsgOperator::subtract, false, true));
  EXPECT_FALSE(is_inside(CsgOperator::subtract, false, false));
}

// Of the six stretches between 0 and 6, a solid has those whose bits are set.
std::vector<double> ends_of(unsigned stretches) {
  std::vector<double> ends;
  for (int i = 0; i <= 6; ++i) {
    const bool before = i > 0 && (stretches >> (i - 1) & 1U) != 0;
    const bool after = i < 6 && (stretches >> i & 1U) != 0;
    if (before != after) ends.push_back(i);
  }
  return ends;
}

// So every state of both sides follows every other, and ends coincide in every way.
TEST(CsgTable, HoldsOnEveryStretchOfEveryTwoLists) {
  for (const CsgOperator op : kOperators)
    for (unsigned left = 0; left < 64; ++left)
      for (unsigned right = 0; right < 64; ++right) {
        const unsigned both = op == CsgOperator::add         ? left | right
                              : op == CsgOperator::intersect ? left & right
                                                             : left & ~right;
        const std::vector<double> expected = ends_of(both);
        const auto found = told(op, ends_of(left), ends_of(right));
        ASSERT_EQ(found.size(), expected.size()) << left << ' ' << right;
        for (std::size_t i = 0; i < found.size(); ++i) {
          EXPECT_EQ(found[i].t, expected[i]);
          EXPECT_EQ(found[i].enters, i % 2 == 0);
          EXPECT_EQ(found[i].normal.x, i % 2 == 0 ? -1 : 1);
        }
      }
}

TEST(CsgSolid, TurnsTheNormalsOfWhatIsTakenAway) {
  const auto found = told(CsgOperator::subtract, {0, 9}, {2, 5});
  ASSERT_EQ(found.size(), 4U);
  EXPECT_EQ(found[1].normal.x, 1);
  EXPECT_EQ(found[2].normal.x, -1);
  EXPECT_EQ(found[0].part, 0);
  EXPECT_EQ(found[1].part, 1);
  EXPECT_EQ(found[2].part, 1);
  EXPECT_EQ(found[3].part, 0);
}

TEST(CsgSolid, NumbersPartsFromTheLeft) {
  const auto part = [](double t) { return std::make_shared<Told>(std::vector<double>{t, t + 1}); };
  const auto pair = [&](double t) {
    return std::make_shared<CsgSolid>(CsgOperator::add, part(t), part(t + 2));
  };
  const CsgSolid four(CsgOperator::add, pair(4), pair(0));
  EXPECT_EQ(four.parts(), 4);
  const auto found = crossings_of(four, {{0, 0, 0}, {1, 0, 0}});
  ASSERT_EQ(found.size(), 8U);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const int expected[] = {2, 2, 3, 3, 0, 0, 1, 1};
    EXPECT_EQ(found[i].part, expected[i]);
  }
}

TEST(CsgSolid, AsksTheRightSideNothingWhereTheLeftIsEmpty) {
  for (const CsgOperator op : kOperators)
    for (const bool is_empty : {true, false}) {
      const auto left =
          std::make_shared<Told>(is_empty ? std::vector<double>{} : std::vector<double>{1, 2});
      const auto right = std::make_shared<Told>(std::vector<double>{1, 3});
      const CsgSolid solid(op, left, right);
      EXPECT_EQ(crossings_of(solid, {{0, 0, 0}, {1, 0, 0}}).empty(),
                is_empty ? op != CsgOperator::add : op == CsgOperator::subtract);
      EXPECT_EQ(right->asked(), is_empty && op != CsgOperator::add ? 0 : 1);
    }
}

// Where the left's surface is seen, not sometimes the one and sometimes the other's.
TEST(CsgSolid, ShowsTheLeftWhereSurfacesCoincide) {
  for (const double off : {-1e-10, 0.0, 1e-10}) {
    for (const CsgOperator op : {CsgOperator::add, CsgOperator::intersect}) {
      const auto found = told(op, {1, 2}, {1 + off, 2 + off});
      ASSERT_EQ(found.size(), 2U);
      EXPECT_EQ(found[0].part, 0);
      EXPECT_EQ(found[1].part, 0);
    }
    EXPECT_TRUE(told(CsgOperator::subtract, {1, 2}, {1 + off, 2 - off}).empty());
    EXPECT_EQ(told(CsgOperator::add, {1, 2}, {2 + off, 3}).size(), 2U);
    EXPECT_TRUE(told(CsgOperator::intersect, {1, 2}, {2 + off, 3}).empty());
    const auto beside = told(CsgOperator::subtract, {1, 2}, {2 + off, 3});
    ASSERT_EQ(beside.size(), 2U);
    EXPECT_EQ(beside[1].part, 0);
  }
}

TEST(CsgSolid, TakesNothingForOneThatIsFurtherApart) {
  EXPECT_EQ(told(CsgOperator::subtract, {1, 2}, {1 + 3e-9, 2}).size(), 2U);
  EXPECT_EQ(told(CsgOperator::add, {1, 2}, {2 + 3e-9, 3}).size(), 4U);
  // What lies between keeps two apart.
  EXPECT_EQ(told(CsgOperator::add, {1, 2, 2 + 1e-10, 3}, {2 + 2e-10, 4}).size(), 4U);
}

TEST(CsgSolid, TwoEndlessSidesMeetAtInfinity) {
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(told(CsgOperator::add, {-inf, inf}, {-inf, 5}).size(), 2U);
  EXPECT_EQ(told(CsgOperator::intersect, {-inf, inf}, {-inf, 5}).size(), 2U);
  const auto rest = told(CsgOperator::subtract, {-inf, inf}, {-inf, 5});
  ASSERT_EQ(rest.size(), 2U);
  EXPECT_EQ(rest[0].t, 5);
  EXPECT_TRUE(told(CsgOperator::subtract, {-inf, inf}, {-inf, inf}).empty());
}

TEST(CsgSolid, ComposesBoundsByTheOperator) {
  const auto box = [](double low, double high) {
    return std::make_shared<BoxSolid>(Box{glm::dvec3(low), glm::dvec3(high)});
  };
  const Box sum = CsgSolid(CsgOperator::add, box(0, 2), box(1, 3)).bounds();
  EXPECT_EQ(sum.lowest_m.x, 0);
  EXPECT_EQ(sum.highest_m.x, 3);
  const Box shared = CsgSolid(CsgOperator::intersect, box(0, 2), box(1, 3)).bounds();
  EXPECT_EQ(shared.lowest_m.x, 1);
  EXPECT_EQ(shared.highest_m.x, 2);
  const Box rest = CsgSolid(CsgOperator::subtract, box(0, 2), box(1, 3)).bounds();
  EXPECT_EQ(rest.lowest_m.x, 0);
  EXPECT_EQ(rest.highest_m.x, 2);
  const auto nothing = std::make_shared<CsgSolid>(CsgOperator::intersect, box(0, 1), box(2, 3));
  EXPECT_GT(nothing->bounds().lowest_m.x, nothing->bounds().highest_m.x);
  const Box again = CsgSolid(CsgOperator::add, nothing, box(5, 6)).bounds();
  EXPECT_EQ(again.lowest_m.x, 5);
  EXPECT_EQ(again.highest_m.x, 6);
}

Body random_tree(std::mt19937_64& engine, int depth) {
  if (depth == 0) {
    const std::vector<Body> all = primitives(engine);
    const auto pick = static_cast<std::size_t>(real(engine, 0, static_cast<double>(all.size())));
    const glm::dvec3 at_m = real(engine, 0, 1) * direction(engine);
    return transformed(all[std::min(pick, all.size() - 1)], shift(at_m) * turn(engine, true));
  }
  const int left_depth = static_cast<int>(real(engine, 0, depth));
  const auto op = kOperators[static_cast<int>(real(engine, 0, 3)) % 3];
  const Body tree = composed(op, random_tree(engine, depth - 1), random_tree(engine, left_depth));
  return real(engine, 0, 1) < 0.3 ? transformed(tree, turn(engine)) : tree;
}

RC_GTEST_PROP(CsgProperty, PointsOfALineAreInATreeAsItsLeavesSay, ()) {
  std::mt19937_64 engine(*rc::gen::arbitrary<std::uint64_t>());
  const Body tree = random_tree(engine, *rc::gen::inRange(1, 7));
  for (int i = 0; i < 30; ++i) {
    const Line line = line_through(engine, {0, 0, 0}, 2, 1e5);
    RC_ASSERT(fault_of(tree, line, engine) == "");
  }
}

// Each takes a ball out of what the ones before have left; depth 50.
TEST(CsgSolid, NestedDifferencesLeaveWhatNoneTookAway) {
  std::mt19937_64 engine(5);
  Body rest = box_body({{-1, -1, -1}, {1, 1, 1}});
  for (int i = 0; i < 50; ++i) {
    const glm::dvec3 at_m = real(engine, 0, 1.5) * direction(engine);
    rest = composed(CsgOperator::subtract, rest,
                    transformed(sphere_body(real(engine, 0.05, 0.4)), shift(at_m)));
  }
  EXPECT_EQ(rest.solid->parts(), 51);
  for (int i = 0; i < 5000; ++i)
    ASSERT_EQ(fault_of(rest, line_through(engine, {0, 0, 0}, 1.7, 1e4), engine), "");
}

// A - (B - (C - ...)): shells within shells.
TEST(CsgSolid, DifferencesNestedToTheRightMakeShells) {
  Body shells = sphere_body(0.02);
  for (int i = 2; i <= 50; ++i)
    shells = composed(CsgOperator::subtract, sphere_body(0.02 * i), shells);
  const auto crossings = crossings_of(*shells.solid, {{-3, 0, 0}, {1, 0, 0}});
  ASSERT_EQ(crossings.size(), 100U);
  for (std::size_t i = 0; i < 50; ++i)
    EXPECT_NEAR(crossings[i].t, 2 + 0.02 * static_cast<double>(i), 1e-12);
  std::mt19937_64 engine(6);
  for (int i = 0; i < 2000; ++i)
    ASSERT_EQ(fault_of(shells, line_through(engine, {0, 0, 0}, 1.7, 1e4), engine), "");
}

}  // namespace
}  // namespace terrview

// Promises of render/objects/solids/solid_object.h.
#include "render/objects/solids/solid_object.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include <glm/geometric.hpp>

#include "render/objects/make_object_set.h"
#include "render/objects/slab_ray.h"
#include "terrain/error.h"
#include "tests/render/objects/solids/body.h"

namespace terrview {
namespace {

// Bodies with holes and bites, finite, about the origin.
Body bitten(std::mt19937_64& engine) {
  const std::vector<Body> all = primitives(engine);
  const auto any = [&] {
    const Body& body = all[static_cast<std::size_t>(real(engine, 0, 8.999))];
    return transformed(body, shift(direction(engine)) * turn(engine));
  };
  const Body cube = box_body({{-1.5, -1.5, -1.5}, {1.5, 1.5, 1.5}});
  const Body sum = composed(CsgOperator::add, any(), any());
  return composed(CsgOperator::subtract, composed(CsgOperator::intersect, cube, sum), any());
}

TEST(SolidObject, IsHitAtTheFirstCrossingAheadOfTheEye) {
  const Body holed = composed(CsgOperator::subtract, sphere_body(3), sphere_body(2));
  const SolidObject shell(holed.solid);
  const auto at = [&](double x, double towards) {
    return shell.first_hit({{x, 0, 0}, {towards, 0, 0}});
  };
  EXPECT_DOUBLE_EQ(at(-5, 4)->distance_m, 2);  // from outside
  EXPECT_EQ(at(-5, 4)->part, 0);
  EXPECT_DOUBLE_EQ(at(-2.5, 1)->distance_m, 0.5);  // from within the shell
  EXPECT_EQ(at(-2.5, 1)->part, 1);
  EXPECT_EQ(at(-2.5, 1)->normal, glm::dvec3(1, 0, 0));
  EXPECT_DOUBLE_EQ(at(-1, 1)->distance_m, 3);  // from within the hollow
  EXPECT_EQ(at(-1, 1)->normal, glm::dvec3(-1, 0, 0));
  EXPECT_DOUBLE_EQ(at(2.5, 1)->distance_m, 0.5);  // outwards
  EXPECT_EQ(at(2.5, 1)->normal, glm::dvec3(1, 0, 0));
  EXPECT_FALSE(at(5, 1));
  EXPECT_FALSE(shell.stops({{-5, 0, 0}, {1, 0, 0}, 1.99}));
  EXPECT_TRUE(shell.stops({{-5, 0, 0}, {1, 0, 0}, 2}));
}

TEST(SolidObject, AnEyeAnywhereSeesTheNearestChangeBetweenInAndOut) {
  std::mt19937_64 engine(1);
  int seen = 0;
  for (int round = 0; round < 330; ++round) {
    const Body body = bitten(engine);
    const SolidObject object(body.solid);
    for (int i = 0; i < 20; ++i) {
      const Ray ray{real(engine, 0, 3) * direction(engine), direction(engine)};
      const auto hit = object.first_hit(ray);
      const Line line{ray.origin_m, ray.direction};
      const bool inside = body.contains(LongPoint(ray.origin_m));
      const double end_m = hit ? hit->distance_m : 6;
      for (int k = 1; k < 50; ++k)
        ASSERT_EQ(body.contains(point_of(line, end_m * k / 50.001)), inside);
      if (!hit) continue;
      ++seen;
      EXPECT_EQ(glm::dot(hit->normal, ray.direction) > 0, inside);
    }
  }
  EXPECT_GT(seen, 2000);
}

TEST(SolidObject, HitsLieWithinTheBoundsToTheLastBit) {
  std::mt19937_64 engine(2);
  for (int round = 0; round < 300; ++round) {
    const glm::dvec3 at_m = std::pow(10.0, real(engine, 0, 6)) * direction(engine);
    const SolidObject object(transformed(bitten(engine), shift(at_m)).solid);
    for (int i = 0; i < 50; ++i) {
      const Line line = line_through(engine, at_m, 2, 1e6);
      const Ray ray{line.origin_m, line.direction};
      const auto hit = object.first_hit(ray);
      if (!hit) continue;
      const auto stretch = SlabRay(ray).within(object.bounds());
      ASSERT_TRUE(stretch);
      EXPECT_GE(hit->distance_m, stretch->enter_m);
      EXPECT_LE(hit->distance_m, stretch->leave_m);
    }
  }
}

// Lifted as far as shading lifts its rays towards lights.
TEST(SolidObject, ARayThatLeavesAConvexSolidDoesNotMeetItAgain) {
  std::mt19937_64 engine(4);
  int left = 0;
  for (int round = 0; round < 200; ++round) {
    const glm::dvec3 at_m = std::pow(10.0, real(engine, 0, 6)) * direction(engine);
    for (const Body& body : {sphere_body(2), box_body({{-1, -2, -3}, {3, 2, 1}}),
                             frustum_body(2, 1, 3), frustum_body(2, 0, 5), frustum_body(1, 1, 4)}) {
      const SolidObject object(transformed(body, shift(at_m) * turn(engine, true)).solid);
      const Line line = line_through(engine, at_m, 1, 1e5);
      const auto hit = object.first_hit({line.origin_m, line.direction});
      if (!hit || glm::dot(hit->normal, line.direction) > 0) continue;
      const glm::dvec3 size_m = glm::abs(hit->position_m);
      const double lift_m = 1e-10 * (size_m.x + size_m.y + size_m.z + 1);
      const glm::dvec3 from_m = hit->position_m + lift_m * hit->normal;
      for (int i = 0; i < 20; ++i) {
        const glm::dvec3 way = direction(engine);
        EXPECT_FALSE(object.stops({from_m, glm::dot(way, hit->normal) < 0 ? -way : way}));
        ++left;
      }
    }
  }
  EXPECT_GT(left, 5000);
}

TEST(SolidObject, ASetFindsWhatTestingEverySolidFinds) {
  std::mt19937_64 engine(3);
  for (const double spread_m : {3.0, 300.0}) {
    Objects objects;
    for (int i = 0; i < 200; ++i) {
      const glm::dvec3 at_m(real(engine, 0, spread_m), real(engine, 0, spread_m), 0);
      try {
        objects.push_back(
            std::make_shared<SolidObject>(transformed(bitten(engine), shift(at_m)).solid));
      } catch (const InputError&) {  // of a body of which nothing was left
      }
    }
    ASSERT_GT(objects.size(), 100U);
    const auto set = make_object_set(objects);
    const ObjectList list(objects);
    int met = 0;
    for (int i = 0; i < 3000; ++i) {
      const auto place = [&] {
        return glm::dvec3(real(engine, 0, spread_m), real(engine, 0, spread_m),
                          real(engine, -1, 1));
      };
      const glm::dvec3 from_m = place();
      const Ray ray{from_m, place() - from_m};
      const auto expected = list.first_hit(ray);
      const auto found = set->first_hit(ray);
      ASSERT_EQ(found.has_value(), expected.has_value());
      EXPECT_EQ(set->stops(ray), expected.has_value());
      if (!found) continue;
      ++met;
      EXPECT_EQ(found->object, expected->object);
      EXPECT_EQ(found->surface.distance_m, expected->surface.distance_m);
      EXPECT_EQ(found->surface.normal, expected->surface.normal);
      EXPECT_EQ(found->surface.part, expected->surface.part);
    }
    EXPECT_GT(met, 500);
  }
}

TEST(SolidObject, RefusesTheEndlessAndTheEmpty) {
  const Body half = half_space_body({0, 0, 1}, 0);
  const Body box = box_body({{-1, -1, -1}, {1, 1, 1}});
  EXPECT_THROW(SolidObject{half.solid}, InputError);
  EXPECT_THROW(SolidObject{composed(CsgOperator::add, box, half).solid}, InputError);
  EXPECT_THROW(SolidObject{composed(CsgOperator::subtract, half, box).solid}, InputError);
  EXPECT_NO_THROW(SolidObject{composed(CsgOperator::intersect, half, box).solid});
  const Body far = transformed(box, shift({5, 0, 0}));
  EXPECT_THROW(SolidObject{composed(CsgOperator::intersect, box, far).solid}, InputError);
}

TEST(SolidObject, SixHalfSpacesAreABox) {
  Body cube = half_space_body({1, 0, 0}, 2);
  for (const glm::dvec3& normal : {glm::dvec3(-1, 0, 0), glm::dvec3(0, 3, 0), glm::dvec3(0, -1, 0),
                                   glm::dvec3(0, 0, 1), glm::dvec3(0, 0, -1)})
    cube = composed(CsgOperator::intersect, cube, half_space_body(normal, 2 * glm::length(normal)));
  const SolidObject object(cube.solid);
  EXPECT_NEAR(object.bounds().lowest_m.y, -2, 1e-12);
  EXPECT_NEAR(object.bounds().highest_m.y, 2, 1e-12);
  const auto hit = object.first_hit({{0, -9, 0}, {0, 1, 0}});
  ASSERT_TRUE(hit);
  EXPECT_DOUBLE_EQ(hit->distance_m, 7);
  EXPECT_EQ(hit->part, 3);
}

}  // namespace
}  // namespace terrview

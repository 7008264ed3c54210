// Promises of render/objects/box.h and slab_ray.h, against closed forms.
#include "render/objects/box.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/objects/slab_ray.h"
#include "tests/render/objects/random_objects.h"

namespace terrview {
namespace {

constexpr Box kBox{{1, 2, 3}, {5, 8, 10}};

void expect_hit(const Ray& ray, double distance_m, const glm::dvec3& position_m, int face) {
  const BoxObject box(kBox);
  const auto hit = box.first_hit(ray);
  ASSERT_TRUE(hit);
  EXPECT_TRUE(box.stops(ray));
  EXPECT_DOUBLE_EQ(hit->distance_m, distance_m);
  EXPECT_EQ(hit->position_m, position_m);
  EXPECT_EQ(hit->part, face);
  glm::dvec3 normal(0);
  normal[face / 2] = face % 2 == 0 ? -1 : 1;
  EXPECT_EQ(hit->normal, normal);
}

TEST(BoxObject, EachFaceIsHitWhereItIs) {
  expect_hit({{-1, 4, 5}, {1, 0, 0}}, 2, {1, 4, 5}, BoxObject::west);
  expect_hit({{9, 4, 5}, {-1, 0, 0}}, 4, {5, 4, 5}, BoxObject::east);
  expect_hit({{2, 0, 5}, {0, 1, 0}}, 2, {2, 2, 5}, BoxObject::south);
  expect_hit({{2, 9, 5}, {0, -1, 0}}, 1, {2, 8, 5}, BoxObject::north);
  expect_hit({{2, 4, 0}, {0, 0, 1}}, 3, {2, 4, 3}, BoxObject::bottom);
  expect_hit({{2, 4, 12}, {0, 0, -1}}, 2, {2, 4, 10}, BoxObject::top);
}

TEST(BoxObject, IsHitFromWithinWhereTheRayLeaves) {
  expect_hit({{2, 4, 5}, {1, 0, 0}}, 3, {5, 4, 5}, BoxObject::east);
  expect_hit({{2, 4, 5}, {0, 0, -1}}, 2, {2, 4, 3}, BoxObject::bottom);
  expect_hit({{1, 4, 5}, {1, 0, 0}}, 0, {1, 4, 5}, BoxObject::west);
  expect_hit({{5, 4, 5}, {1, 0, 0}}, 0, {5, 4, 5}, BoxObject::east);
  expect_hit({{1, 4, 5}, {0, 0, 1}}, 0, {1, 4, 5}, BoxObject::west);
  expect_hit({{5, 4, 5}, {0, 1, 0}}, 0, {5, 4, 5}, BoxObject::east);
}

TEST(BoxObject, IsClosedAndItsRaysEnd) {
  const BoxObject box(kBox);
  EXPECT_TRUE(box.stops({{1, 0, 3}, {0, 1, 0}}));                          // along an edge
  EXPECT_TRUE(box.stops({{0, 1, 3}, {1, 1, 0}}));                          // at an edge
  EXPECT_TRUE(box.stops({{0, 4, 10}, {1, 0, 0}}));                         // along the top
  EXPECT_FALSE(box.stops({{0, 4, std::nextafter(10, 11)}, {1, 0, 0}}));    // over it
  EXPECT_FALSE(box.stops({{std::nextafter(1, 0), 4, 20}, {0, 0, -1}}));    // beside it
  EXPECT_TRUE(box.stops({{-1, 4, 5}, {1, 0, 0}, 2}));                      // ends at the wall
  EXPECT_FALSE(box.stops({{-1, 4, 5}, {1, 0, 0}, std::nextafter(2, 0)}));  // before it
  EXPECT_FALSE(box.stops({{2, 4, 5}, {1, 0, 0}, 2}));                      // within
  EXPECT_FALSE(box.stops({{6, 4, 5}, {1, 0, 0}}));                         // away
}

TEST(BoxObject, DistancesAreMetresForDirectionsOfAnyLength) {
  const auto hit = BoxObject(kBox).first_hit({{-1, 4, 5}, {1e-3, 0, 0}});
  ASSERT_TRUE(hit);
  EXPECT_DOUBLE_EQ(hit->distance_m, 2);
}

TEST(BoxObject, FlatBoxesAreHitFromBothSides) {
  const BoxObject wall(Box{{1, 0, 0}, {1, 5, 5}});
  EXPECT_EQ(wall.first_hit({{0, 1, 1}, {1, 0, 0}})->part, BoxObject::west);
  EXPECT_EQ(wall.first_hit({{3, 1, 1}, {-1, 0, 0}})->part, BoxObject::east);
  EXPECT_TRUE(wall.stops({{1, -1, 1}, {0, 1, 0}}));
}

// The farthest of the near planes against the nearest of the far ones, without SlabRay.
TEST(BoxObject, AgreesWithTheSixPlanes) {
  RandomObjects random(5);
  for (int i = 0; i < 20000; ++i) {
    const Ray ray = random.ray();
    const BoxObject box(Box{{10, 20, 0}, {70, 90, 9}});
    double expected_m = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis)
      for (const glm::dvec3& corner : {box.bounds().lowest_m, box.bounds().highest_m}) {
        if (ray.direction[axis] == 0) continue;
        const double t = (corner[axis] - ray.origin_m[axis]) / ray.direction[axis];
        glm::dvec3 at = ray.origin_m + t * ray.direction;
        at[axis] = corner[axis];
        const double distance_m = t * glm::length(ray.direction);
        const bool on_face = glm::all(glm::greaterThanEqual(at, box.bounds().lowest_m)) &&
                             glm::all(glm::lessThanEqual(at, box.bounds().highest_m));
        if (on_face && t >= 0 && distance_m <= ray.length_m)
          expected_m = std::min(expected_m, distance_m);
      }
    const auto hit = box.first_hit(ray);
    ASSERT_EQ(hit.has_value(), std::isfinite(expected_m));
    if (!hit) continue;
    EXPECT_NEAR(hit->distance_m, expected_m, 1e-12 * (expected_m + 1));
    EXPECT_NEAR(glm::length(hit->position_m - ray.origin_m), hit->distance_m,
                1e-9 + 1e-12 * expected_m);
  }
}

TEST(SlabRay, ABoxBehindOrBesideIsMissed) {
  EXPECT_FALSE(SlabRay({{0, 0, 0}, {-1, 0, 0}}).within({{1, -1, -1}, {2, 1, 1}}));
  EXPECT_FALSE(SlabRay({{0, 3, 0}, {1, 0, 0}}).within({{1, -1, -1}, {2, 1, 1}}));
  const auto stretch = SlabRay({{0, 1, 1}, {2, 0, 0}}).within({{1, -1, -1}, {2, 1, 1}});
  ASSERT_TRUE(stretch);
  EXPECT_EQ(stretch->enter_m, 1);
  EXPECT_EQ(stretch->leave_m, 2);
}

}  // namespace
}  // namespace terrview

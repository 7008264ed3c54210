// Promises of render/objects/sphere.h, against closed forms.
#include "render/objects/sphere.h"

#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "render/objects/slab_ray.h"
#include "tests/render/objects/random_objects.h"

namespace terrview {
namespace {

TEST(Sphere, IsHitWhereTheQuadraticSays) {
  RandomObjects random(11);
  for (int i = 0; i < 20000; ++i) {
    const glm::dvec3 centre(40, 50, 4);
    const double radius = 30;
    const Ray ray = random.ray();
    using Long = long double;
    Long aa = 0;
    Long ab = 0;
    Long bb = -Long{radius} * radius;
    for (int axis = 0; axis < 3; ++axis) {
      const Long d = ray.direction[axis];
      const Long o = Long{ray.origin_m[axis]} - centre[axis];
      aa += d * d;
      ab += d * o;
      bb += o * o;
    }
    const Long discriminant = ab * ab - aa * bb;
    const Long scale = std::sqrt(aa);
    if (std::abs(discriminant) < 1e-6L * ab * ab) continue;  // grazes, or is far
    Long expected_m = -1;
    if (discriminant > 0) {
      expected_m = (-ab - std::sqrt(discriminant)) / scale;
      if (expected_m < 0) expected_m = (-ab + std::sqrt(discriminant)) / scale;
    }
    const bool is_hit = expected_m >= 0 && expected_m <= ray.length_m;
    const auto hit = Sphere(centre, radius).first_hit(ray);
    ASSERT_EQ(hit.has_value(), is_hit);
    if (!hit) continue;
    EXPECT_NEAR(hit->distance_m, static_cast<double>(expected_m), 1e-9);
    EXPECT_NEAR(glm::length(hit->position_m - centre), radius, 1e-9);
    EXPECT_NEAR(glm::dot(hit->normal, hit->position_m - centre), radius, 1e-9);
  }
}

TEST(Sphere, IsHitFromWithinAndBehindNever) {
  const Sphere sphere({0, 0, 0}, 2);
  EXPECT_DOUBLE_EQ(sphere.first_hit({{1, 0, 0}, {1, 0, 0}})->distance_m, 1);
  EXPECT_DOUBLE_EQ(sphere.first_hit({{-5, 0, 0}, {3, 0, 0}})->distance_m, 3);
  EXPECT_FALSE(sphere.stops({{5, 0, 0}, {1, 0, 0}}));
  EXPECT_FALSE(sphere.stops({{-5, 0, 0}, {1, 0, 0}, 2.9}));
  EXPECT_FALSE(sphere.stops({{-5, 1.9, 1.9}, {1, 0, 0}}));  // in the bounds' corner
  EXPECT_TRUE(sphere.stops({{-5, 2, 0}, {1, 0, 0}}));       // touches
}

TEST(Sphere, HitsLieWithinTheBoundsToTheLastBit) {
  RandomObjects random(12);
  for (const auto& object : random.scattered(400, 20))
    for (int i = 0; i < 100; ++i) {
      const Ray ray = random.ray();
      const auto hit = object->first_hit(ray);
      if (!hit) continue;
      const auto stretch = SlabRay(ray).within(object->bounds());
      ASSERT_TRUE(stretch);
      EXPECT_GE(hit->distance_m, stretch->enter_m);
      EXPECT_LE(hit->distance_m, stretch->leave_m);
    }
}

}  // namespace
}  // namespace terrview

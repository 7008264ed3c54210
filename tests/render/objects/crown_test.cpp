// One test per promise of render/objects/crown.h.
#include "render/objects/crown.h"

#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>

namespace terrview {
namespace {

// A ball of radius 3 about (10, 0, 7), on a trunk of radius 0.5.
const Crown kTree({.level = {{10, 0}, 0, {0, 0}},
                   .foot_m = 0,
                   .bottom_m = 4,
                   .top_m = 10,
                   .radius_m = 3,
                   .trunk_radius_m = 0.5});

TEST(Crown, IsABallOnATrunk) {
  const auto leaves = kTree.first_hit({{0, 0, 7}, {2, 0, 0}});
  ASSERT_TRUE(leaves);
  EXPECT_NEAR(leaves->distance_m, 7, 1e-12);
  EXPECT_EQ(leaves->part, Crown::kLeaves);
  EXPECT_NEAR(glm::distance(leaves->normal, {-1, 0, 0}), 0, 1e-12);
  const auto trunk = kTree.first_hit({{10, -9, 2}, {0, 1, 0}});
  ASSERT_TRUE(trunk);
  EXPECT_NEAR(trunk->distance_m, 8.5, 1e-12);
  EXPECT_EQ(trunk->part, Crown::kTrunk);
  EXPECT_NEAR(glm::distance(trunk->normal, {0, -1, 0}), 0, 1e-12);
  EXPECT_FALSE(kTree.stops({{10, -9, -1}, {0, 1, 0}})) << "below the trunk";
  EXPECT_FALSE(kTree.stops({{11, -9, 2}, {0, 1, 0}})) << "beside it";
}

TEST(Crown, IsMetOnItsSurfaceWithinItsBoundsAndTheRay) {
  const Crown tree({.level = {{10, 0}, 1, {0.1, -0.05}},
                    .foot_m = -1,
                    .bottom_m = 2,
                    .top_m = 12,
                    .radius_m = 3,
                    .trunk_radius_m = 0.2});
  const LevelPlane level{{10, 0}, 1, {0.1, -0.05}};
  const Box box = tree.bounds();
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 eye(10 + 30 * std::sin(i), 30 * std::cos(i), 8 * std::sin(2.3 * i));
    const glm::dvec3 to(10 + 3 * std::cos(3.1 * i), 3 * std::sin(4.7 * i), 6 + 6 * std::sin(i));
    Ray ray{eye, to - eye};
    const auto hit = tree.first_hit(ray);
    if (!hit) continue;
    ++hits;
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_GE(hit->position_m[axis], box.lowest_m[axis]);
      EXPECT_LE(hit->position_m[axis], box.highest_m[axis]);
    }
    EXPECT_LT(glm::dot(hit->normal, ray.direction), 1e-9) << "outward";
    if (hit->part == Crown::kLeaves) {
      const glm::dvec3 at = level.point(hit->position_m) - glm::dvec3(10, 0, 7);
      EXPECT_NEAR((at.x * at.x + at.y * at.y) / 9 + at.z * at.z / 25, 1, 1e-9);
    }
    ray.length_m = hit->distance_m * (1 - 1e-12);
    EXPECT_FALSE(tree.stops(ray));
  }
  EXPECT_GT(hits, 700);
}

}  // namespace
}  // namespace terrview

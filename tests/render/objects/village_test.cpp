// Buildings and trees on the accelerator: the set that rays are led through finds in them what
// testing every object finds.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <random>
#include <vector>

#include "render/objects/crown.h"
#include "render/objects/make_object_set.h"
#include "render/objects/prism.h"
#include "render/objects/slab_ray.h"

namespace terrview {
namespace {

constexpr int kSide = 12;  // lots along a side, 10 m each

class Random {
 public:
  explicit Random(std::uint32_t seed) : engine_(seed) {}
  double in(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(engine_); }

 private:
  std::mt19937 engine_;
};

// A house fills its lot, so that neighbours share a wall; or stands in it, turned.
std::shared_ptr<const Object> house(Random& random, glm::dvec2 lot_m, glm::dvec2 slope) {
  Polygon::Ring ring{{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  if (random.below(2) == 0) {
    const double turn = random.in(0, 1.5);
    for (glm::dvec2& corner : ring) {
      const glm::dvec2 from_middle = 0.6 * (corner - 5.0);
      corner = glm::dvec2(5) +
               glm::dvec2(from_middle.x * std::cos(turn) - from_middle.y * std::sin(turn),
                          from_middle.x * std::sin(turn) + from_middle.y * std::cos(turn));
    }
  }
  for (glm::dvec2& corner : ring) corner += lot_m;
  const double eaves_m = random.in(3, 12);
  const RoofOptions roof{.shape = static_cast<RoofShape>(random.below(6)),
                         .eaves_m = eaves_m,
                         .top_m = eaves_m + random.in(0, 4)};
  return std::make_shared<Prism>(
      Polygon(std::vector<Polygon::Ring>{ring}),
      PrismShape{.level = {lot_m + 5.0, random.in(-3, 3), slope}, .base_m = -1, .roof = roof});
}

std::shared_ptr<const Object> tree(Random& random, glm::dvec2 lot_m, glm::dvec2 slope) {
  return std::make_shared<Crown>(CrownShape{.level = {lot_m + 5.0, 0, slope},
                                            .foot_m = -1,
                                            .bottom_m = random.in(1, 3),
                                            .top_m = random.in(5, 15),
                                            .radius_m = random.in(2, 8),
                                            .trunk_radius_m = random.in(0, 0.5)});
}

Objects village(Random& random, glm::dvec2 corner_m) {
  const glm::dvec2 slope(random.in(-0.01, 0.01), random.in(-0.01, 0.01));
  Objects objects;
  for (int row = 0; row < kSide; ++row)
    for (int column = 0; column < kSide; ++column) {
      const glm::dvec2 lot_m = corner_m + 10.0 * glm::dvec2(column, row);
      if (random.below(3) > 0) objects.push_back(house(random, lot_m, slope));
      if (random.below(4) == 0) objects.push_back(tree(random, lot_m, slope));
    }
  return objects;
}

// From afar, from a roof, along the lots' lines, through their corners, and straight down.
Ray ray_over(Random& random, glm::dvec2 corner_m) {
  const auto place = [&](bool on_line) {
    return on_line ? 10.0 * random.below(kSide + 1) : random.in(-20, 140);
  };
  const bool along_x = random.below(3) == 0;
  const bool along_y = random.below(3) == 0;
  const glm::dvec3 from(glm::dvec2(place(along_x), place(along_y)) + corner_m, random.in(-2, 30));
  glm::dvec3 to(glm::dvec2(place(along_x), place(along_y)) + corner_m, random.in(-2, 20));
  if (random.below(3) == 0) to.z = from.z;
  if (along_x && random.below(2) == 0) to.x = from.x;
  if (along_y && random.below(2) == 0) to.y = from.y;
  if (to == from) to.z -= 1;
  return {from - (random.below(2) == 0 ? 1000.0 : 0.0) * (to - from), to - from};
}

TEST(AVillage, IsMetAsWhenEveryObjectIsTested) {
  Random random(1);
  int hits = 0;
  for (const glm::dvec2 corner_m : {glm::dvec2(0, 0), {-60, -60}, {40000.7, -91234.1}}) {
    for (int i = 0; i < 4; ++i) {
      const Objects objects = village(random, corner_m);
      const auto set = make_object_set(objects);
      const ObjectList list(objects);
      for (int j = 0; j < 1500; ++j) {
        const Ray ray = ray_over(random, corner_m);
        const auto expected = list.first_hit(ray);
        const auto found = set->first_hit(ray);
        ASSERT_EQ(found.has_value(), expected.has_value());
        ASSERT_EQ(set->stops(ray), expected.has_value());
        if (!expected) continue;
        ++hits;
        ASSERT_EQ(found->object, expected->object);
        ASSERT_EQ(found->surface.distance_m, expected->surface.distance_m);
        const Object& object = *objects[static_cast<std::size_t>(found->object)];
        const auto stretch = SlabRay(ray).within(object.bounds());
        ASSERT_TRUE(stretch);
        ASSERT_GE(found->surface.distance_m, stretch->enter_m);
        ASSERT_LE(found->surface.distance_m, stretch->leave_m);
      }
    }
  }
  EXPECT_GT(hits, 5000);
}

}  // namespace
}  // namespace terrview

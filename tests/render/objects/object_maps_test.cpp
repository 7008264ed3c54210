// Promises of render/objects/rectangle_map.h and cell_map.h: what testing every object finds, bit
// for bit.
#include "render/objects/rectangle_map.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <memory>
#include <optional>
#include <sstream>
#include <string>

#include "render/objects/box.h"
#include "render/objects/cell_map.h"
#include "render/objects/make_object_set.h"
#include "tests/render/objects/random_objects.h"

namespace terrview {
namespace {

std::string to_string(const glm::dvec3& v) {
  std::ostringstream text;
  text.precision(17);
  text << '{' << v.x << ", " << v.y << ", " << v.z << '}';
  return text.str();
}

std::string to_string(const std::optional<ObjectHit>& hit) {
  if (!hit) return "nothing";
  std::ostringstream text;
  text.precision(17);
  text << "object " << hit->object << " part " << hit->surface.part << " at "
       << hit->surface.distance_m << ' ' << to_string(hit->surface.position_m) << ' '
       << to_string(hit->surface.normal);
  return text.str();
}

std::string to_string(const Objects& objects) {
  std::string text;
  for (const auto& object : objects)
    text += to_string(object->bounds().lowest_m) + to_string(object->bounds().highest_m) + ' ';
  return text;
}

// What is wrong with a set's answers for a ray; nothing if they are those of every object.
std::string fault(const ObjectSet& set, const Ray& ray) {
  const ObjectList all(set.objects());
  const std::string expected = to_string(all.first_hit(ray));
  const std::string found = to_string(set.first_hit(ray));
  const bool stops = set.stops(ray);
  if (found == expected && stops == (expected != "nothing")) return {};
  std::ostringstream text;
  text.precision(17);
  text << "ray from " << to_string(ray.origin_m) << " along " << to_string(ray.direction) << " of "
       << ray.length_m << ": " << found << ", not " << expected << (stops ? "; stops" : "");
  return text.str();
}

Objects boxes(std::initializer_list<Box> list) {
  Objects objects;
  for (const Box& box : list) objects.push_back(std::make_shared<BoxObject>(box));
  return objects;
}

template <class Map>
class MapOfObjects : public testing::Test {};
using Maps = testing::Types<RectangleMap, CellMap>;
TYPED_TEST_SUITE(MapOfObjects, Maps);

template <class Map>
class MapOfObjectsLong : public testing::Test {};
TYPED_TEST_SUITE(MapOfObjectsLong, Maps);

// Compares in `scenes` scenes of each kind with `rays` rays each.
template <class Map>
void compare_with_every_object(std::uint64_t seed, int scenes, int rays) {
  for (int scene = 0; scene < scenes; ++scene) {
    RandomObjects random(seed + static_cast<std::uint64_t>(scene));
    const int size = 1 + scene % 7;
    const Map lattice(random.on_lattice(1 + scene % 23, size));
    const Map scattered(random.scattered(1 + scene % 60, 1 + scene % 30));
    for (int i = 0; i < rays; ++i) {
      ASSERT_EQ(fault(lattice, random.lattice_ray(size)), "") << to_string(lattice.objects());
      ASSERT_EQ(fault(scattered, random.ray()), "") << "scattered scene " << scene;
    }
  }
}

TYPED_TEST(MapOfObjects, FindsWhatTestingEveryObjectFinds) {
  compare_with_every_object<TypeParam>(1, 250, 200);
}

TYPED_TEST(MapOfObjects, FindsItAmongThousands) {
  RandomObjects random(9);
  const TypeParam map(random.scattered(3000, 2));
  for (int i = 0; i < 500; ++i) ASSERT_EQ(fault(map, random.ray()), "");
}

TYPED_TEST(MapOfObjectsLong, FindsWhatTestingEveryObjectFinds) {
  compare_with_every_object<TypeParam>(1000000, 5000, 1000);
}

template <class Map>
void compare_on_lattice() {
  RandomObjects random(*rc::gen::arbitrary<std::uint64_t>());
  const int size = *rc::gen::inRange(1, 6);
  const Map map(random.on_lattice(*rc::gen::inRange(1, 12), size));
  for (int i = 0; i < 50; ++i) {
    const std::string message = fault(map, random.lattice_ray(size));
    RC_LOG() << to_string(map.objects());
    RC_ASSERT(message == "");
  }
}
RC_GTEST_PROP(RectangleMapProperty, FindsWhatTestingEveryObjectFinds, ()) {
  compare_on_lattice<RectangleMap>();
}
RC_GTEST_PROP(CellMapProperty, FindsWhatTestingEveryObjectFinds, ()) {
  compare_on_lattice<CellMap>();
}

// The ray meets B inside of A's rectangle's list, and D, nearer, only in a later rectangle.
TYPED_TEST(MapOfObjects, AHitBeyondTheCurrentRectangleHidesNoNearerObject) {
  const TypeParam map(
      boxes({{{0, 0, 0}, {4, 4, 0.5}}, {{3, 3, 0}, {10, 10, 9}}, {{4.5, 2, 0}, {5.5, 2.8, 9}}}));
  const Ray ray{{0, 0, 1}, {4, 2, 0}};
  const auto hit = map.first_hit(ray);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->object, 2);
  EXPECT_EQ(fault(map, ray), "");
}

// How many objects' bounds a ray enters, up to a distance.
int entered(const Objects& objects, const Ray& ray, double distance_m) {
  int count = 0;
  for (const auto& object : objects) {
    const auto stretch = SlabRay(ray).within(object->bounds());
    if (stretch && stretch->enter_m <= distance_m) ++count;
  }
  return count;
}

TYPED_TEST(MapOfObjects, TestsNoObjectTwiceAndFewBeyondTheHit) {
  std::int64_t tests = 0;
  std::int64_t entered_before = 0;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    RandomObjects random(seed);
    const TypeParam map(random.scattered(60, 40));
    for (int i = 0; i < 100; ++i) {
      const Ray ray = random.ray();
      ObjectCounts counts;
      const auto hit = map.first_hit(ray, &counts);
      const double nearest_m = hit ? hit->surface.distance_m : SlabRay::kFarthest_m;
      EXPECT_LE(counts.tests, entered(map.objects(), ray, SlabRay::kFarthest_m));
      tests += counts.tests;
      entered_before += entered(map.objects(), ray, nearest_m);
    }
  }
  EXPECT_LE(static_cast<double>(tests), 1.01 * static_cast<double>(entered_before));
}

TYPED_TEST(MapOfObjects, LooksAtFewPlacesOfManyThatARayPassesOver) {
  Objects objects;
  for (int i = 0; i < 10000; ++i) {
    const glm::dvec3 low(10 * (i % 100), 10 * (i / 100), 0);
    objects.push_back(std::make_shared<BoxObject>(Box{low, low + glm::dvec3(5, 5, 3)}));
  }
  objects.push_back(std::make_shared<BoxObject>(Box{{990, 990, 0}, {995, 995, 300}}));
  const TypeParam map(objects);
  ObjectCounts counts;
  const auto hit = map.first_hit({{-10, -10, 280}, {1, 1, -0.01}}, &counts);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->object, 10000);
  EXPECT_LE(counts.steps, 20);
}

// The walls are where the map's cells of heights border on each other.
TYPED_TEST(MapOfObjects, FindsWhatARayGrazesFarAhead) {
  Objects objects;
  for (int i = 0; i < 100; ++i) {
    const glm::dvec3 low(10 * (i % 10), 10 * (i / 10), 0);
    const double height_m = i == 95 ? 5 : 1;
    objects.push_back(std::make_shared<BoxObject>(Box{low, low + glm::dvec3(10, 10, height_m)}));
  }
  const TypeParam map(objects);
  for (const double x : {50, 55, 60})
    for (const double y : {-5, 105}) {
      const Ray ray{{x, y, 3}, {0, y < 0 ? 1 : -1, 0}};
      EXPECT_TRUE(map.stops(ray));
      EXPECT_EQ(fault(map, ray), "");
    }
}

TEST(RectangleMap, HoldsManyObjectsInOnePlace) {
  Objects objects;
  for (int i = 0; i < 3000; ++i) {
    const double r = i;
    objects.push_back(std::make_shared<BoxObject>(Box{{-r, -r, -r}, {r, r, r}}));
    objects.push_back(std::make_shared<BoxObject>(Box{{-5, -5, 0}, {5, 5, 5}}));
  }
  const RectangleMap map(objects);
  EXPECT_LT(map.bytes(), objects.size() * 10000);
  RandomObjects random(7);
  for (int i = 0; i < 30; ++i) EXPECT_EQ(fault(map, random.ray()), "");
}

TEST(RectangleMap, KnowsItsRectangles) {
  const RectangleMap one(boxes({{{0, 0, 0}, {1, 1, 1}}}));
  EXPECT_EQ(one.rectangles(), 1U);
  EXPECT_EQ(one.empty_rectangles(), 0U);
  const RectangleMap diagonal(boxes({{{0, 0, 0}, {1, 1, 1}}, {{2, 2, 0}, {3, 3, 1}}}));
  EXPECT_EQ(diagonal.rectangles() - diagonal.empty_rectangles(), 2U);
}

// A grid of boxes that share walls: no ray from above slips between two.
TYPED_TEST(MapOfObjects, NoRaySlipsBetweenBoxesThatTouch) {
  Objects objects;
  for (int i = 0; i < 100; ++i) {
    const glm::dvec3 low(i % 10 / 10.0, i / 10 / 10.0, 0);
    const glm::dvec3 high((i % 10 + 1) / 10.0, (i / 10 + 1) / 10.0, 1);
    objects.push_back(std::make_shared<BoxObject>(Box{low, high}));
  }
  const TypeParam map(objects);
  for (int i = 0; i <= 10; ++i)
    for (int j = 0; j <= 100; ++j) {
      const glm::dvec3 to(i / 10.0, j / 100.0, 1);
      for (const glm::dvec3& from : {glm::dvec3(0.3, 0.7, 5), glm::dvec3(to.x, 9, 3), to + 1.0}) {
        EXPECT_TRUE(map.stops({from, to - from}));
        EXPECT_EQ(fault(map, {from, to - from}), "");
      }
    }
}

// A village in the corner of a wide plain with a few farms, and an even city.
TEST(MakeObjectSet, TakesCellsForWhatIsSpreadEvenly) {
  Objects village = RandomObjects(1).scattered(2000, 1);
  const Box far{{20000, 20000, 0}, {20010, 20010, 5}};
  EXPECT_NE(dynamic_cast<const CellMap*>(make_object_set(village).get()), nullptr);
  village.push_back(std::make_shared<BoxObject>(far));
  EXPECT_NE(dynamic_cast<const RectangleMap*>(make_object_set(village).get()), nullptr);
  const Objects wide = RandomObjects(2).scattered(2000, 100);
  EXPECT_NE(dynamic_cast<const RectangleMap*>(make_object_set(wide).get()), nullptr);
}

TEST(MakeObjectSet, HoldsObjectsInOnePlace) {
  const Objects points(10, std::make_shared<BoxObject>(Box{{1, 1, 1}, {1, 1, 1}}));
  EXPECT_EQ(fault(*make_object_set(points), {{0, 0, 0}, {1, 1, 1}}), "");
}

TEST(MakeObjectSet, HoldsAnyNumberOfObjects) {
  RandomObjects random(3);
  for (const int count : {0, 1, 2, 5, 100}) {
    const auto set = make_object_set(random.scattered(count, 10));
    EXPECT_EQ(set->objects().size(), static_cast<std::size_t>(count));
    for (int i = 0; i < 100; ++i) EXPECT_EQ(fault(*set, random.ray()), "");
  }
}

}  // namespace
}  // namespace terrview

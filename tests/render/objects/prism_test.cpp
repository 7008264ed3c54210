// One test per promise of render/objects/prism.h and polygon.h.
#include "render/objects/prism.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "tests/render/objects/prism_oracle.h"

namespace terrview {
namespace {

using Rings = std::vector<Polygon::Ring>;

class Random {
 public:
  explicit Random(std::uint32_t seed) : engine_(seed) {}
  double in(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  glm::dvec3 point(double reach) {
    return {in(-reach, reach), in(-reach, reach), in(-reach, reach)};
  }
  // From about the solids towards them.
  Ray ray() {
    const glm::dvec3 origin = point(6);
    return {origin, point(2) - origin};
  }

 private:
  std::mt19937 engine_;
};

const Polygon::Ring kSquare{{-2, -1}, {2, -1}, {2, 1}, {-2, 1}};

// A star about the origin, and a smaller one in it.
Rings star_with_hole(Random& random, int corners) {
  Rings rings(2);
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    const double radius = random.in(1, 3);
    const glm::dvec2 way(std::cos(angle), std::sin(angle));
    rings[0].push_back(radius * way);
    rings[1].push_back(random.in(0.1, 0.5) * radius * way);
  }
  return rings;
}

Prism prism_of(const Rings& rings, const RoofOptions& roof, double base_m = -1,
               glm::dvec2 slope = {0, 0}) {
  return {Polygon(rings), {.level = {{0, 0}, 0, slope}, .base_m = base_m, .roof = roof}};
}

// The height of a roof over the square, by the formulas of schoolbooks.
double roof_height_m(RoofShape shape, glm::dvec2 p) {
  constexpr double kEaves = 1;
  constexpr double kRise = 1;
  switch (shape) {
    case RoofShape::flat:
      return kEaves;
    case RoofShape::gabled:
      return kEaves + kRise * (1 - std::abs(p.y));
    case RoofShape::hipped:
      return kEaves + kRise * std::min(1 - std::abs(p.y), 2 - std::abs(p.x));
    case RoofShape::pyramidal:
      return kEaves + kRise * std::min(1 - std::abs(p.y), 1 - std::abs(p.x) / 2);
    case RoofShape::skillion:
      return kEaves + kRise * (1 - p.y) / 2;
    case RoofShape::dome:
      return kEaves + kRise * std::sqrt(std::max(0.0, 1 - p.x * p.x / 4 - p.y * p.y));
  }
  return 0;
}

constexpr RoofShape kShapes[] = {RoofShape::flat,      RoofShape::gabled,   RoofShape::hipped,
                                 RoofShape::pyramidal, RoofShape::skillion, RoofShape::dome};

PrismOracle oracle_of(RoofShape shape, glm::dvec2 slope) {
  return {.rings = {kSquare},
          .slope = slope,
          .base_m = -1,
          .roof_m = [shape](glm::dvec2 p) { return roof_height_m(shape, p); },
          .lowest_roof_m = 1,
          .highest_roof_m = 2};
}

RC_GTEST_PROP(Prism, MeetsRaysWhereItsPointsBeginUnderEveryRoof, (std::uint32_t seed)) {
  Random random(seed);
  const glm::dvec2 slope(random.in(-0.2, 0.2), random.in(-0.2, 0.2));
  for (const RoofShape shape : kShapes) {
    RoofOptions roof{.shape = shape, .eaves_m = 1, .top_m = 2};
    if (shape == RoofShape::skillion) roof.downhill = glm::dvec2(0, 1);
    const Prism prism = prism_of({kSquare}, roof, -1, slope);
    const PrismOracle oracle = oracle_of(shape, slope);
    for (int i = 0; i < 5; ++i) {
      const Ray ray = random.ray();
      const auto hit = prism.first_hit(ray);
      const auto expected_m = oracle.first_m(ray);
      RC_ASSERT(hit.has_value() == expected_m.has_value());
      RC_ASSERT(prism.stops(ray) == hit.has_value());
      if (hit) RC_ASSERT(std::abs(hit->distance_m - *expected_m) < 1e-9);
    }
  }
}

RC_GTEST_PROP(Prism, MeetsRaysWhereItsPointsBeginOverAnyPolygonWithHoles, (std::uint32_t seed)) {
  Random random(seed);
  const Rings rings = star_with_hole(random, 5 + static_cast<int>(seed % 40));
  const PrismOracle oracle{.rings = rings,
                           .slope = {0.1, -0.05},
                           .base_m = -1,
                           .roof_m = [](glm::dvec2) { return 1.5; },
                           .lowest_roof_m = 1.5,
                           .highest_roof_m = 1.5};
  const Prism prism = prism_of(rings, {.eaves_m = 1.5}, -1, {0.1, -0.05});
  for (int i = 0; i < 10; ++i) {
    const Ray ray = random.ray();
    const auto hit = prism.first_hit(ray);
    const auto expected_m = oracle.first_m(ray);
    RC_ASSERT(hit.has_value() == expected_m.has_value());
    if (hit) RC_ASSERT(std::abs(hit->distance_m - *expected_m) < 1e-9);
  }
}

RC_GTEST_PROP(Prism, LetsNoRaySlipToAPointInside, (std::uint32_t seed)) {
  Random random(seed);
  const Rings rings = star_with_hole(random, 9);
  for (const RoofShape shape : kShapes) {
    const Prism prism = prism_of(rings, {.shape = shape, .eaves_m = 1, .top_m = 2});
    for (std::size_t i = 0; i < 9; ++i) {
      // Just inside of the outline, and of the eaves: through corners and along edges.
      const glm::dvec2 corner = rings[0][i];
      const glm::dvec3 inside(corner * (1 - 1e-9), 1 - 1e-9);
      const glm::dvec3 outside[] = {{corner * 2.0, 1},
                                    {corner * 3.0, 9},
                                    {corner, 5},
                                    {corner, -7},
                                    {2.0 * rings[0][(i + 1) % 9], 1}};
      for (const glm::dvec3& eye : outside) {
        const glm::dvec3 way = inside - eye;
        const auto hit = prism.first_hit({eye, way});
        RC_ASSERT(hit.has_value());
        RC_ASSERT(hit->distance_m <= glm::length(way) + 1e-12);
      }
    }
  }
}

RC_GTEST_PROP(Prism, LeavesNoGapBesideANeighbourOfTheSameWall, (std::uint32_t seed)) {
  Random random(seed);
  const glm::dvec2 a(random.in(-1, 1), random.in(-1, 1));
  const glm::dvec2 b = a + glm::dvec2(random.in(-1, 1), 1);
  const Prism left = prism_of({{a, b, a - glm::dvec2(3, 0)}}, {.eaves_m = 1});
  const Prism right = prism_of({{b, a + glm::dvec2(3, 0.5), a}}, {.eaves_m = 1});
  for (int i = 0; i < 50; ++i) {
    const glm::dvec2 on_wall = a + random.in(0.01, 0.99) * (b - a);
    const glm::dvec3 eye = glm::dvec3(on_wall, 1) + glm::dvec3(random.in(-1, 1) * (b - a), 3);
    for (const Ray& ray : {Ray{{on_wall, 5}, {0, 0, -1}}, Ray{eye, glm::dvec3(on_wall, 1) - eye}})
      RC_ASSERT(left.stops(ray) || right.stops(ray));
  }
}

RC_GTEST_PROP(Prism, KeepsItsHitsInItsBoundsAndOnTheRay, (std::uint32_t seed)) {
  Random random(seed);
  const glm::dvec2 slope(random.in(-0.1, 0.1), random.in(-0.1, 0.1));
  for (const RoofShape shape : kShapes) {
    const Prism prism =
        prism_of(star_with_hole(random, 7), {.shape = shape, .eaves_m = 1, .top_m = 3}, 0, slope);
    const Box box = prism.bounds();
    const Ray ray = random.ray();
    const auto hit = prism.first_hit(ray);
    if (!hit) continue;
    for (int axis = 0; axis < 3; ++axis) {
      RC_ASSERT(hit->position_m[axis] >= box.lowest_m[axis]);
      RC_ASSERT(hit->position_m[axis] <= box.highest_m[axis]);
    }
    RC_ASSERT(std::abs(glm::length(hit->normal) - 1) < 1e-12);
    RC_ASSERT(std::abs(glm::distance(hit->position_m, ray.origin_m) - hit->distance_m) < 1e-12);
    Ray shorter = ray;
    shorter.length_m = hit->distance_m * (1 - 1e-12);
    RC_ASSERT(!prism.stops(shorter));
    shorter.length_m = hit->distance_m;
    RC_ASSERT(prism.stops(shorter));
  }
}

TEST(Prism, TurnsItsNormalsOutward) {
  const Prism prism = prism_of({kSquare}, {.shape = RoofShape::gabled, .eaves_m = 1, .top_m = 2});
  const auto normal = [&](const Ray& ray) { return prism.first_hit(ray).value().normal; };
  const double half = std::sqrt(0.5);
  EXPECT_EQ(normal({{5, 0.5, 0}, {-1, 0, 0}}), glm::dvec3(1, 0, 0));
  EXPECT_EQ(normal({{-5, 0.5, 0}, {1, 0, 0}}), glm::dvec3(-1, 0, 0));
  EXPECT_EQ(normal({{0, 0, 0}, {1, 0, 0}}), glm::dvec3(1, 0, 0)) << "from inside";
  EXPECT_EQ(normal({{0, 0, -9}, {0, 0, 1}}), glm::dvec3(0, 0, -1));
  EXPECT_NEAR(glm::distance(normal({{0, 0.5, 9}, {0, 0, -1}}), {0, half, half}), 0, 1e-15);
  EXPECT_NEAR(glm::distance(normal({{0, -0.5, 9}, {0, 0, -1}}), {0, -half, half}), 0, 1e-15);
}

TEST(Prism, NamesThePartThatIsHit) {
  const Prism prism = prism_of({kSquare}, {.shape = RoofShape::dome, .eaves_m = 1, .top_m = 2});
  EXPECT_EQ(prism.first_hit({{5, 0, 0}, {-1, 0, 0}})->part, Prism::kWall);
  EXPECT_EQ(prism.first_hit({{0, 0, 9}, {0, 0, -1}})->part, Prism::kRoof);
  EXPECT_EQ(prism.first_hit({{1.9, 0.9, 9}, {0, 0, -1}})->part, Prism::kRoof) << "beside the dome";
  EXPECT_EQ(prism.first_hit({{0, 0, -9}, {0, 0, 1}})->part, Prism::kBase);
}

TEST(Prism, IsTheSameHoweverItsRingsAreWritten) {
  const Polygon::Ring hole{{-1, -0.5}, {1, -0.5}, {1, 0.5}, {-1, 0.5}};
  const Polygon::Ring reversed(kSquare.rbegin(), kSquare.rend());
  Polygon::Ring closed = kSquare;
  closed.push_back(kSquare.front());
  Polygon::Ring repeated;
  for (const glm::dvec2& corner : kSquare) repeated.insert(repeated.end(), 3, corner);
  Polygon::Ring with_spike = kSquare;
  with_spike.insert(with_spike.begin() + 1, {{0, -1}, {0, -4}, {0, -1}});
  const Prism plain = prism_of({kSquare, hole}, {.eaves_m = 1});
  Random random(7);
  int hits = 0;
  for (const Polygon::Ring& ring : {reversed, closed, repeated, with_spike}) {
    const Prism other = prism_of({ring, hole}, {.eaves_m = 1});
    for (int i = 0; i < 2000; ++i) {
      const Ray ray = random.ray();
      const auto expected = plain.first_hit(ray);
      const auto found = other.first_hit(ray);
      ASSERT_EQ(found.has_value(), expected.has_value());
      if (!found) continue;
      ++hits;
      EXPECT_NEAR(found->distance_m, expected->distance_m, 1e-12);
    }
  }
  EXPECT_GT(hits, 1000);
}

TEST(Prism, TurnsItsRidgeAsItIsTold) {
  const auto height_at = [](const RoofOptions& roof, glm::dvec2 p) {
    return 9 - prism_of({kSquare}, roof).first_hit({{p, 9}, {0, 0, -1}})->distance_m;
  };
  RoofOptions roof{.shape = RoofShape::gabled, .eaves_m = 1, .top_m = 2};
  EXPECT_NEAR(height_at(roof, {1.5, 0.5}), 1.5, 1e-12) << "along the longer side";
  roof.ridge_across = true;
  EXPECT_NEAR(height_at(roof, {1.5, 0.5}), 1.25, 1e-12);
  roof.downhill = glm::dvec2(0.1, 1);
  EXPECT_NEAR(height_at(roof, {1.5, 0.5}), 1.5, 1e-12) << "the direction has the last word";
  roof.shape = RoofShape::skillion;
  roof.downhill = glm::dvec2(-1, 0);
  EXPECT_NEAR(height_at(roof, {1, 0}), 1.75, 1e-12);
}

TEST(Prism, OfAHundredThousandCornersFollowsItsCircle) {
  Polygon::Ring circle;
  constexpr int kCorners = 100000;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2 * std::numbers::pi * i / kCorners;
    circle.emplace_back(100 * std::cos(angle), 100 * std::sin(angle));
  }
  for (const RoofShape shape : kShapes) {
    const Prism prism = prism_of({circle}, {.shape = shape, .eaves_m = 1, .top_m = 20});
    Random random(3);
    // Slow enough to notice, were every edge looked at.
    for (int i = 0; i < 20000; ++i) {
      const double across = random.in(-99, 99);
      const auto hit = prism.first_hit({{across, -500, 0.5}, {0, 1, 0}});
      ASSERT_TRUE(hit);
      ASSERT_NEAR(hit->distance_m, 500 - std::sqrt(1e4 - across * across), 1e-5);
      ASSERT_EQ(hit->part, Prism::kWall);
    }
  }
}

TEST(Polygon, AreaIsTheOutlineLessItsHoles) {
  const Rings rings{kSquare, {{0, 0}, {0, 0.5}, {0.5, 0.5}, {0.5, 0}}};
  EXPECT_DOUBLE_EQ(Polygon(rings).area(), 7.75);
}

}  // namespace
}  // namespace terrview

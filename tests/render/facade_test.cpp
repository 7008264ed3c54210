// One test per promise of render/facade.h.
#include "render/facade.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <vector>

#include "render/objects/make_object_set.h"
#include "render/objects/scene_objects.h"
#include "tests/support/scenes.h"

namespace terrview {
namespace {

// A building over a rectangle, from 5 m below the eye, where the plain is, up to `top_m`.
std::shared_ptr<const Prism> block(glm::dvec2 low, glm::dvec2 high, double top_m,
                                   const RoofOptions& roof = {}) {
  const std::vector<Polygon::Ring> rings{
      {{low.x, low.y}, {high.x, low.y}, {high.x, high.y}, {low.x, high.y}}};
  RoofOptions raised = roof;
  if (roof.shape == RoofShape::flat) raised.eaves_m = raised.top_m = top_m;
  return std::make_shared<Prism>(Polygon(rings), PrismShape{.base_m = -8, .roof = raised});
}

// On a plain 5 m below the eye.
Scene scene_of(const std::vector<std::shared_ptr<const Prism>>& blocks) {
  Scene scene;
  scene.terrain = std::make_shared<Terrain>(
      make_terrain(make_grid(201, 201, [](int, int) { return 100; }),
                   {.eye_uv = {100, 100}, .spacing_m = {10, 10}, .eye_height_m = 105},
                   SurfaceModel::hyperboloid));
  auto objects = std::make_shared<SceneObjects>();
  objects->set = make_object_set(Objects(blocks.begin(), blocks.end()));
  objects->looks.resize(blocks.size());
  scene.objects = objects;
  return scene;
}

FacadeSight sight(const std::vector<std::shared_ptr<const Prism>>& blocks,
                  const FacadeOptions& options = {}) {
  const std::vector<const Prism*> first{blocks.front().get()};
  return facade_sight(scene_of(blocks), first, options);
}

TEST(Facade, OfAFreeBlockIsItsWallsTowardsTheEye) {
  const FacadeSight seen = sight({block({-10, 100}, {10, 130}, 20)});
  EXPECT_NEAR(seen.facing_m2, 20 * 25, 1e-6) << "of the front alone, above the ground";
  EXPECT_NEAR(seen.seen_m2, seen.facing_m2, 1e-6);
  const FacadeSight corner = sight({block({50, 100}, {70, 130}, 20)});
  EXPECT_NEAR(corner.facing_m2, (20 + 30) * 25, 1e-6);
}

TEST(Facade, BehindAWallIsSeenOverIt) {
  // The wall's top, 10 m above the eye at 50 m, is at 20 m before the block at 100 m.
  const FacadeSight seen =
      sight({block({-10, 100}, {10, 130}, 40), block({-100, 49}, {100, 50}, 10)});
  EXPECT_NEAR(seen.seen_m2 / seen.facing_m2, (40 - 100 * 10 / 50.0) / 45, 0.01);
}

// A building stands already in the outline of a higher one: pictures show the former up to its top.
TEST(Facade, ThatCoincidesWithAnEarlierBuildingsIsSeenAboveItAlone) {
  const auto old = block({-10, 100}, {10, 130}, 10);
  const auto planned = block({-10, 100}, {10, 130}, 40);
  const std::vector<const Prism*> parts{planned.get()};
  const FacadeSight seen = facade_sight(scene_of({old, planned}), parts);
  EXPECT_NEAR(seen.facing_m2, 20 * 45, 1e-6);
  EXPECT_NEAR(seen.seen_m2 / seen.facing_m2, 30 / 45.0, 0.01);
}

TEST(Facade, OfACourtCountsTheWallsThatFaceTheEye) {
  const std::vector<Polygon::Ring> rings{{{-30, 100}, {30, 100}, {30, 160}, {-30, 160}},
                                         {{-20, 110}, {20, 110}, {20, 150}, {-20, 150}}};
  const auto court = std::make_shared<Prism>(
      Polygon(rings), PrismShape{.base_m = -8, .roof = {.eaves_m = 20, .top_m = 20}});
  const std::vector<const Prism*> parts{court.get()};
  const FacadeSight seen = facade_sight(scene_of({court}), parts);
  // The front; and the far wall and the sides of the court, which are all behind the front.
  EXPECT_NEAR(seen.facing_m2, (60 + 3 * 40) * 25, 1e-6);
  EXPECT_NEAR(seen.seen_m2, 60 * 25, 1e-6);
}

TEST(Facade, BetweenPartsOfOneBuildingIsNone) {
  const auto near = block({-10, 100}, {10, 120}, 20);
  const auto far = block({-10, 120}, {10, 140}, 20);
  const std::vector<const Prism*> parts{near.get(), far.get()};
  EXPECT_NEAR(facade_sight(scene_of({near, far}), parts).facing_m2, 20 * 25, 1e-6);
}

TEST(Facade, UnderAGableRisesToTheRoof) {
  // The ridge runs away from the eye: the front is a rectangle with a triangle on it.
  const FacadeSight seen = sight(
      {block({-10, 100}, {10, 150}, 0, {.shape = RoofShape::gabled, .eaves_m = 10, .top_m = 20})});
  EXPECT_NEAR(seen.facing_m2, 20 * 15 + 20 * 10 / 2.0, 0.5);
  const FacadeSight dome = sight(
      {block({-10, 100}, {10, 150}, 0, {.shape = RoofShape::dome, .eaves_m = 10, .top_m = 20})});
  EXPECT_NEAR(dome.facing_m2, 20 * 15, 1e-6);
}

// Points drawn at random over the walls, each tried against every block: a ray for each, and no
// code of the facade's. Five standard deviations of either are allowed.
TEST(Facade, AgreesWithRandomPointsAndHardlyDependsOnItsSamples) {
  constexpr double kShareError = 4e-4;  // that of render/facade.h
  std::mt19937 engine(7);
  const auto in = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  };
  const auto place = [&](glm::dvec2 low, glm::dvec2 high) {
    const double y = in(low.y, high.y);
    const double x = in(low.x, high.x);
    return glm::dvec2(x, y);
  };
  for (int round = 0; round < 12; ++round) {
    const glm::dvec2 low = place({20, 100}, {60, 150});
    const glm::dvec2 high = low + place({10, 10}, {40, 40});
    const double top_m = in(10, 50);
    std::vector<std::shared_ptr<const Prism>> blocks{block(low, high, top_m)};
    for (int i = 0; i < 4; ++i) {
      const glm::dvec2 corner = place({0, 20}, {70, 80});
      const double rise_m = in(0, 25);
      blocks.push_back(block(corner, corner + place({3, 3}, {15, 15}), rise_m));
    }
    const double south_m2 = (high.x - low.x) * (top_m + 5);
    const double west_m2 = (high.y - low.y) * (top_m + 5);
    constexpr int kPoints = 20000;
    int free = 0;
    for (int i = 0; i < kPoints; ++i) {
      const bool south = in(0, south_m2 + west_m2) < south_m2;
      const double z = in(-5, top_m);
      const double along_m = south ? in(low.x, high.x) : in(low.y, high.y);
      const glm::dvec3 point(south ? along_m : low.x, south ? low.y : along_m, z);
      const Ray ray{.direction = point, .length_m = glm::length(point) - 1e-3};
      free += std::none_of(blocks.begin(), blocks.end(),
                           [&](const auto& one) { return one->first_hit(ray).has_value(); })
                  ? 1
                  : 0;
    }
    const FacadeSight seen = sight(blocks);
    EXPECT_NEAR(seen.facing_m2, south_m2 + west_m2, 1e-6);
    const double share = seen.seen_m2 / seen.facing_m2;
    const double drawn = static_cast<double>(free) / kPoints;
    EXPECT_NEAR(share, drawn,
                5 * std::hypot(std::sqrt(drawn * (1 - drawn) / kPoints), kShareError));
    const FacadeSight finer = sight(blocks, {.samples = 100000, .threads = 1});
    EXPECT_NEAR(share, finer.seen_m2 / finer.facing_m2, 5 * kShareError);
  }
}

TEST(Facade, IsTheSameForAnyNumberOfThreads) {
  const std::vector<std::shared_ptr<const Prism>> blocks{block({-10, 100}, {10, 130}, 40),
                                                         block({-5, 49}, {100, 50}, 10)};
  const FacadeSight one = sight(blocks, {.threads = 1});
  const FacadeSight many = sight(blocks, {.threads = 7});
  EXPECT_EQ(one.facing_m2, many.facing_m2);
  EXPECT_EQ(one.seen_m2, many.seen_m2);
}

}  // namespace
}  // namespace terrview

// Whether a summit is really seen: render/summit_sight.h.
#include "render/summit_sight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "render/objects/box.h"
#include "render/objects/make_object_set.h"
#include "render/objects/scene_objects.h"
#include "tests/render/hills.h"
#include "tests/support/random_scene.h"

namespace terrview {
namespace {

constexpr double kPost_m = 100;  // of scene_over()

// A dome 100 m high and some posts across, on a plain, and a wall across at `wall_row`.
Scene dome_scene(double wall_m, double eye_m, int wall_row = 70) {
  return scene_over(make_grid(121, 121,
                              [&](int column, int row) {
                                const double r = std::hypot(column - 60, row - 40);
                                const double dome = std::max(0.0, 100 - 4 * r * r);
                                return dome + (row == wall_row ? wall_m : 0);
                              }),
                    eye_m);
}

constexpr glm::dvec2 kDome_m{0, (119 - 40) * kPost_m};

std::optional<glm::dvec3> seen(const Scene& scene, glm::dvec2 ground_m, double reach_m = 200) {
  return seen_summit(scene, level_camera({100, 50}), ground_m, reach_m);
}

TEST(SeenSummit, IsTheTopOfADome) {
  const auto top = seen(dome_scene(0, 20), kDome_m);
  ASSERT_TRUE(top);
  EXPECT_NEAR(top->x, 0, 1e-6);
  EXPECT_NEAR(top->z, 80, 1);
  EXPECT_NEAR(top->y, kDome_m.y, 100);
}

// Its own convex ground hides a place a post or two behind the crest; not one far behind.
TEST(SeenSummit, ForgivesAPlaceThatIsOffItsTop) {
  const Scene scene = dome_scene(0, 20);
  for (const double off_m : {-150.0, -50.0, 80.0, 150.0})
    EXPECT_TRUE(seen(scene, kDome_m + glm::dvec2(0, off_m))) << off_m;
  EXPECT_FALSE(seen(scene, kDome_m + glm::dvec2(0, 500)));
}

// The line from the eye at 20 m, 79 posts away, to the top at 100 m passes 49 posts away at 69.6 m.
TEST(SeenSummit, IsHiddenByAWallThatReachesTheLineOfSight) {
  EXPECT_TRUE(seen(dome_scene(68, 20), kDome_m));
  EXPECT_FALSE(seen(dome_scene(71, 20), kDome_m));
}

TEST(SeenSummit, IsHiddenByAnObject) {
  Scene scene = dome_scene(0, 20);
  const auto with_tower = [&](double top_m) {
    auto objects = std::make_shared<SceneObjects>();
    // Its heights are over the eye.
    objects->set =
        make_object_set({std::make_shared<BoxObject>(Box{{-20, 4880, -20}, {20, 4900, top_m}})});
    objects->looks = {{}};
    scene.objects = objects;
    return seen(scene, kDome_m).has_value();
  };
  EXPECT_TRUE(with_tower(48));
  EXPECT_FALSE(with_tower(51));
}

TEST(SeenSummit, IsNoneWhereThereIsNoGroundOrTheEyeStands) {
  const Scene scene = dome_scene(0, 20);
  EXPECT_FALSE(seen(scene, {1e6, 0}));
  EXPECT_FALSE(seen(scene, {0, 150}));
}

TEST(SeenSummit, OfParallelRaysIsHiddenByWhatStandsBeforeIt) {
  const Camera camera({.projection = Projection::orthographic,
                       .pitch_rad = -2 * kRadians,
                       .width_m = 5000,
                       .size_px = {100, 50}});
  // 30 posts before the dome parallel rays that pass its top are 105 m higher.
  EXPECT_TRUE(seen_summit(dome_scene(200, 500), camera, kDome_m, 200));
  EXPECT_FALSE(seen_summit(dome_scene(210, 500), camera, kDome_m, 200));
  const Camera plan({.projection = Projection::orthographic,
                     .pitch_rad = -90 * kRadians,
                     .width_m = 5000,
                     .size_px = {100, 50}});
  EXPECT_TRUE(seen_summit(dome_scene(400, 500), plan, kDome_m, 200));
}

// Against the ground's slopes as seen from the eye, sampled densely along the azimuth.
TEST(SeenSummit, AgreesWithTheProfileOfTheGround) {
  const Scene scene = scene_over(hills_grid(), 520);
  const Terrain& terrain = *scene.terrain;
  Random random(7);
  int compared = 0;
  int visible = 0;
  for (int i = 0; i < 400; ++i) {
    const glm::dvec2 place(random.uniform(-5000, 5000), random.uniform(1000, 11000));
    if (!terrain.ground_at(place)) continue;
    const double reach_m = random.uniform(50, 400);
    const double distance_m = glm::length(place);
    double before = -1e9;
    double at = -1e9;
    for (double s = 5; s < distance_m + reach_m; s += 2) {
      const glm::dvec2 ground_m = place * (s / distance_m);
      const auto ground = terrain.ground_at(ground_m);
      if (!ground) continue;
      const double slope = terrain.frame().at(ground_m).z_m(ground->scene_height_m) / s;
      (s < distance_m - reach_m ? before : at) =
          std::max(s < distance_m - reach_m ? before : at, slope);
    }
    // The surface under a ray is not quite that of ground_at().
    if (std::abs(at - before) < 2e-3) continue;
    const auto top = seen(scene, place, reach_m);
    EXPECT_EQ(top.has_value(), at > before) << i;
    if (top) {
      EXPECT_NEAR(top->z / glm::length(glm::dvec2(*top)), at, 2e-3) << i;
    }
    ++compared;
    visible += top ? 1 : 0;
  }
  EXPECT_GT(compared, 200);
  EXPECT_GT(visible, 40);
  EXPECT_LT(visible, compared - 40);
}

TEST(HeightAboveSurroundings, IsThatOverAPlainAndNothingOnIt) {
  const Scene scene = dome_scene(0, 20);
  EXPECT_NEAR(height_above_surroundings_m(*scene.terrain, kDome_m), 100, 15);
  EXPECT_NEAR(height_above_surroundings_m(*scene.terrain, {0, 3000}), 0, 1e-9);
}

TEST(SummitReach, IsTwoPostsButThirtyMetresAtLeast) {
  const auto reach_m = [](glm::dvec2 spacing_m) {
    const Terrain terrain =
        make_terrain(make_grid(9, 9, [](int, int) { return 0.0; }),
                     {.eye_uv = {4, 4}, .spacing_m = spacing_m}, SurfaceModel::hyperboloid);
    return summit_reach_m(terrain, terrain.ground_at({0, 0}).value(), {0, 0});
  };
  EXPECT_DOUBLE_EQ(reach_m({100, 60}), 200);
  EXPECT_DOUBLE_EQ(reach_m({16, 40}), 80);
  EXPECT_DOUBLE_EQ(reach_m({10, 14}), 30);
}

}  // namespace
}  // namespace terrview

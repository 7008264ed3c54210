// Promises of render/plan.h.
#include "render/plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "render/meet.h"
#include "render/objects/scene_objects.h"
#include "render/objects/sphere.h"
#include "render/shade.h"
#include "render/water.h"
#include "tests/render/hills.h"
#include "tests/support/bent_map.h"

namespace terrview {
namespace {

Scene scene_with_a_ball() {
  Scene scene = hills_scene();
  scene.contours.interval_m = 40;
  auto objects = std::make_shared<SceneObjects>();
  objects->set = std::make_shared<ObjectList>(
      Objects{std::make_shared<Sphere>(glm::dvec3(430, 2210, 100), 333)});
  objects->looks = {{}};
  scene.objects = objects;
  return scene;
}

// The eye of hills_scene() is over the post (59.5, 118) of 120 x 120, 100 m apart.
constexpr int kPosts = 120;

float furthest(const glm::vec3& a, const glm::vec3& b) {
  return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
}

// The twin: single parallel rays through the whole tracer. Rays that run along a line of the grid
// may see another cell's normal, or another side of a shadow's edge.
TEST(Plan, IsAnOrthographicViewFromStraightAbove) {
  for (const bool smooth : {true, false}) {
    Scene scene = scene_with_a_ball();
    scene.normals = smooth ? NormalKind::smooth : NormalKind::facet;
    const PlanFrame plan =
        render_plan(scene, {.size_px = {50, 40}, .corner_uv = {30.2, 60.3}, .step_uv = {1, 1}});
    // 50 pixels of 100 m whose middle is the post (55.2, 80.3).
    const glm::dvec2 middle_m = 100.0 * glm::dvec2(55.2 - 59.5, 118 - 80.3);
    int differ = 0;
    for (int row = 0; row < 40; ++row) {
      for (int column = 0; column < 50; ++column) {
        const glm::dvec2 at_m = middle_m + 100.0 * glm::dvec2(column + 0.5 - 25, 20 - (row + 0.5));
        const std::vector<Ray> rays{{{at_m, 2000}, {0, 0, -1}}};
        RayHits hits{{scene.terrain->first_hit(rays[0])}};
        ObjectCounts objects;
        meet_objects(scene, rays, hits, objects);
        ShadowCounts shadows;
        const auto expected = shade(scene, {.pixel = {.m = 100}}, rays, hits, shadows);
        differ += furthest(plan.image.at(column, row), expected[0].color) > 1e-4F ? 1 : 0;
        ASSERT_EQ(plan.covered.at(column, row), 1);
      }
    }
    EXPECT_LE(differ, 2);
  }
}

TEST(Plan, ShowsEachPostInItsPixel) {
  Scene scene = hills_scene();
  scene.light = {.sun = {0, 0, 0}, .ambient = {1, 1, 1}, .casts_shadows = false};
  const PlanFrame plan = render_plan(scene, {.size_px = {kPosts, kPosts}});
  const HeightGrid& grid = *scene.terrain->layers().front().grid;
  for (int row = 0; row < kPosts; ++row) {
    for (int column = 0; column < kPosts; ++column)
      ASSERT_LT(furthest(plan.image.at(column, row), scene.tints.at(grid.at(column, row))), 1e-6F);
  }
}

TEST(Plan, ShowsTheWaterOverLowGroundInItsOwnColour) {
  Scene scene = hills_scene();
  scene.light = {.sun = {0, 0, 0}, .ambient = {1, 1, 1}, .casts_shadows = false};
  const PlanFrame dry = render_plan(scene, {.size_px = {kPosts, kPosts}});
  const double level_m = 280;
  scene.water = std::make_shared<const Water>(Water{.level_m = level_m});
  const PlanFrame wet = render_plan(scene, {.size_px = {kPosts, kPosts}});
  const HeightGrid& grid = *scene.terrain->layers().front().grid;
  std::optional<glm::vec3> water;
  int flooded = 0;
  for (int row = 0; row < kPosts; ++row) {
    for (int column = 0; column < kPosts; ++column) {
      const glm::vec3& color = wet.image.at(column, row);
      if (static_cast<double>(grid.at(column, row)) > level_m + 1) {
        ASSERT_EQ(color, dry.image.at(column, row));
      } else if (static_cast<double>(grid.at(column, row)) < level_m - 1) {
        if (!water) water = color;
        ASSERT_LT(furthest(color, *water), 1e-6F);
        ++flooded;
      }
    }
  }
  EXPECT_GT(flooded, 100);
  EXPECT_LT(flooded, kPosts * kPosts - 100);
}

// The Dead Sea risen to the ocean's level, seen from its shore.
TEST(Plan, HidesWhatIsUnderItsWaterAlsoOverAnEyeBelowSeaLevel) {
  Scene scene = scene_over(make_grid(30, 30, [](int, int) { return -430.0; }), -400);
  auto objects = std::make_shared<SceneObjects>();
  objects->set =
      std::make_shared<ObjectList>(Objects{std::make_shared<Sphere>(glm::dvec3(0, 900, 0), 300)});
  objects->looks = {{}};
  scene.water = std::make_shared<const Water>(Water{.level_m = 0});
  const PlanLattice lattice{.size_px = {30, 30}};
  const auto empty = render_plan(scene, lattice).image.pixels();
  scene.objects = objects;
  EXPECT_EQ(render_plan(scene, lattice).image.pixels(), empty);
}

// A post is covered where one of the cells around it is ground.
TEST(Plan, IsEmptyWhereThereIsNoGround) {
  HeightGrid grid = hills_grid();
  const auto post = [&](int column, int row) -> float& {
    return grid.heights_m[static_cast<std::size_t>(row * kPosts + column)];
  };
  for (const auto& [column, row] : {std::pair(0, 0), {40, 50}, {42, 50}, {41, 52}, {119, 60}})
    post(column, row) = kVoid;
  const HeightGrid holed = grid;
  const PlanFrame plan = render_plan(scene_over(std::move(grid), 700), {.size_px = {120, 120}});
  int empty = 0;
  for (int row = 0; row < kPosts; ++row) {
    for (int column = 0; column < kPosts; ++column) {
      bool ground = false;
      for (int y = std::max(0, row - 1); y <= std::min(row, kPosts - 2); ++y) {
        for (int x = std::max(0, column - 1); x <= std::min(column, kPosts - 2); ++x)
          ground = ground || holed.has_ground(x, y);
      }
      ASSERT_EQ(plan.covered.at(column, row) != 0, ground) << column << ", " << row;
      empty += ground ? 0 : 1;
    }
  }
  EXPECT_GE(empty, 7);  // the voids, a post between two of them, and a corner
}

TEST(Plan, ShowsAnotherGridThroughAHole) {
  const Place place{.eye_uv = {10, 10}, .spacing_m = {100, 100}, .eye_height_m = 900};
  HeightGrid fine = make_grid(21, 21, [](int, int) { return 400.0; });
  fine.heights_m[7 * 21 + 9] = kVoid;
  HeightGrid coarse = make_grid(31, 31, [](int, int) { return 100.0; });
  Scene scene = hills_scene();
  scene.light = {.sun = {0, 0, 0}, .ambient = {1, 1, 1}, .casts_shadows = false};
  scene.terrain =
      std::make_shared<Terrain>(std::vector<TerrainLayer>{make_layer(std::move(fine), place),
                                                          make_layer(std::move(coarse), place)},
                                VerticalFrame{.eye_height_m = 900}, SurfaceModel::hyperboloid);
  const PlanFrame plan = render_plan(scene, {.size_px = {21, 21}});
  for (int row = 0; row < 21; ++row) {
    for (int column = 0; column < 21; ++column) {
      const bool in_hole = column == 9 && row == 7;
      ASSERT_EQ(plan.covered.at(column, row), 1);
      ASSERT_LT(furthest(plan.image.at(column, row), scene.tints.at(in_hole ? 100 : 400)), 1e-6F);
    }
  }
}

TEST(Plan, ShowsNothingBeyondTheOutermostPosts) {
  const PlanFrame plan = render_plan(hills_scene(), {.size_px = {4, 3}, .corner_uv = {-1.4, -0.6}});
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column)
      EXPECT_EQ(plan.covered.at(column, row) != 0, column > 0 && row > 0);
  }
}

TEST(Plan, FindsItsPostsThroughABentMap) {
  Scene scene = hills_scene();
  scene.light = {.sun = {0, 0, 0}, .ambient = {1, 1, 1}, .casts_shadows = false};
  const auto grid = scene.terrain->layers().front().grid;
  const auto map = std::make_shared<BentGroundMap>(glm::dvec2(60, 60), 100.0, 1e-9, 20000.0);
  scene.terrain =
      std::make_shared<Terrain>(std::vector<TerrainLayer>{{grid, map}},
                                VerticalFrame{.eye_height_m = 900}, SurfaceModel::hyperboloid);
  const PlanFrame plan = render_plan(scene, {.size_px = {kPosts, kPosts}});
  for (int i = 0; i < kPosts; ++i)
    ASSERT_LT(furthest(plan.image.at(i, 7), scene.tints.at(grid->at(i, 7))), 1e-6F);
}

// Parts begin within the runs of columns that find their ground one from another, and beside the
// grid; its swirl is so strong that from the eye some would not.
TEST(Plan, OfAPartIsThatPartOfTheWholeToTheByte) {
  Scene scene = scene_with_a_ball();
  const auto map = std::make_shared<BentGroundMap>(glm::dvec2(60, 60), 100.0, 2e-7, 20000.0);
  scene.terrain = std::make_shared<Terrain>(
      std::vector<TerrainLayer>{{scene.terrain->layers().front().grid, map}},
      VerticalFrame{.eye_height_m = 900}, SurfaceModel::hyperboloid);
  PlanLattice lattice{.size_px = {260, 40},
                      .corner_uv = {14.2, 31.3},
                      .step_uv = {0.43, 1.1},
                      .first_px = {-90, 3}};
  const PlanFrame whole = render_plan(scene, lattice);
  const glm::ivec2 whole_first_px = lattice.first_px;
  lattice.size_px = {40, 11};
  for (const glm::ivec2 first_px : {glm::ivec2(-90, 3), {-71, 20}, {-64, 9}, {-1, 3}, {77, 32}}) {
    lattice.first_px = first_px;
    const PlanFrame part = render_plan(scene, lattice);
    const glm::ivec2 offset = first_px - whole_first_px;
    for (int row = 0; row < lattice.size_px.y; ++row)
      for (int column = 0; column < lattice.size_px.x; ++column) {
        ASSERT_EQ(part.image.at(column, row), whole.image.at(offset.x + column, offset.y + row));
        ASSERT_EQ(part.covered.at(column, row),
                  whole.covered.at(offset.x + column, offset.y + row));
      }
  }
  const auto& covered = whole.covered.pixels();
  EXPECT_GT(std::count(covered.begin(), covered.end(), 0), 1000);
  EXPECT_GT(std::count(covered.begin(), covered.end(), 1), 1000);
}

TEST(Plan, MeansItsSamplesButForThoseBesideTheGround) {
  Scene scene = hills_scene();
  scene.tints = {.stops = {{0, {0.5F, 0.5F, 0.5F}}}};
  scene.light = {.sun = {0, 0, 0}, .ambient = {1, 1, 1}, .casts_shadows = false};
  const PlanFrame plan = render_plan(scene, {.size_px = {kPosts, kPosts}}, {.samples = 16});
  for (const glm::vec3& color : plan.image.pixels())
    ASSERT_LT(furthest(color, glm::vec3(0.5F)), 1e-6F);
}

TEST(Plan, IsTheSameForAnyNumberOfThreads) {
  const Scene scene = scene_with_a_ball();
  const PlanLattice lattice{.size_px = {200, 170}, .step_uv = {0.61, 0.7}};
  const PlanFrame one = render_plan(scene, lattice, {.threads = 1, .samples = 2});
  const PlanFrame four = render_plan(scene, lattice, {.threads = 4, .samples = 2});
  EXPECT_EQ(one.image.pixels(), four.image.pixels());
  EXPECT_EQ(one.counts.shadow_rays, four.counts.shadow_rays);
}

}  // namespace
}  // namespace terrview

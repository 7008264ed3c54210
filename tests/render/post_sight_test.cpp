// One test per promise of render/post_sight.h, against long-double rays (tests/support/oracle.h).
#include "render/post_sight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <numeric>
#include <vector>

#include <glm/geometric.hpp>

#include "render/objects/object_set.h"
#include "render/objects/sphere.h"
#include "terrain/post_sight_lines.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/oracle.h"
#include "tests/support/random_scene.h"
#include "tests/support/sanitized.h"
#include "tests/support/scenes.h"

namespace terrview {
namespace {

using Seen = std::vector<std::uint8_t>;

const HeightGrid& first_grid(const Terrain& terrain) { return *terrain.layers()[0].grid; }

// The same ground under an eye that stands so high above it.
Terrain raised(const Terrain& terrain, double above_m) {
  VerticalFrame frame = terrain.frame();
  if (const auto ground = terrain.ground_at({0, 0}))
    frame.eye_height_m = ground->scene_height_m + above_m;
  return {terrain.layers(), frame, terrain.model()};
}

// A height that matters on this grid.
double some_height_m(Random& random, const Terrain& terrain) {
  const HeightRange range = height_range(first_grid(terrain));
  return random.log_uniform(1e-3, 1) * terrain.frame().z_scale *
         std::max(1.0F, range.highest_m - range.lowest_m);
}

template <class MakeTerrain>
void for_random_eyes(std::uint64_t seed, const MakeTerrain& make,
                     const std::function<void(const Terrain&, double observer_m)>& check) {
  Random random(seed);
  for (int i = 0; i < 60; ++i) {
    for (const SurfaceModel model : kSurfaceModels) {
      const Terrain any = make(random, model);
      const Terrain terrain = raised(any, random.chance(0.9) ? some_height_m(random, any) : -1);
      check(terrain, random.chance(0.8) ? some_height_m(random, any) : 0);
    }
  }
}

void expect_same_as_plain(const Terrain& terrain, double observer_m) {
  const HeightGrid& grid = first_grid(terrain);
  const Seen seen = posts_that_see_eye(terrain, grid, {.observer_m = observer_m});
  const Seen plain = posts_that_see_eye(terrain, grid, {.observer_m = observer_m, .plain = true});
  const auto differs = std::mismatch(seen.begin(), seen.end(), plain.begin()).first;
  if (differs == seen.end()) return;
  const auto post = static_cast<int>(differs - seen.begin());
  const glm::dvec2 eye_uv = terrain.layers()[0].map->to_grid({0, 0});
  ADD_FAILURE() << name_of(terrain.model()) << ", post " << post % grid.columns << ' '
                << post / grid.columns << " of " << grid.columns << " x " << grid.rows
                << ", eye at " << eye_uv.x << ' ' << eye_uv.y << ", z scale "
                << terrain.frame().z_scale << ", curvature "
                << terrain.frame().north_curvature_per_m << ", observer " << observer_m
                << ", holes " << terrain.has_holes() << ": seen is " << int{*differs};
}

Terrain special(Random& random, SurfaceModel model) {
  return random_terrain(random, model, Position::special);
}
Terrain general(Random& random, SurfaceModel model) {
  return random_terrain(random, model, Position::general);
}

TEST(PostSight, IsThatOfARayAPost) {
  for_random_eyes(1, general, expect_same_as_plain);
  for_random_eyes(2, special, expect_same_as_plain);
}

// Where lines of sight run along lines of the grid that part ground from holes, the least that
// rounding does to them decides between the two.
Terrain beside_holes(Random& random, SurfaceModel model) {
  while (true) {
    const Terrain terrain = special(random, model);
    const glm::dvec2 eye_uv = terrain.layers()[0].map->to_grid({0, 0});
    if (terrain.has_holes() &&
        (eye_uv.x == std::round(eye_uv.x) || eye_uv.y == std::round(eye_uv.y)))
      return terrain;
  }
}

TEST(PostSight, IsThatOfARayAPostAlongTheEdgesOfHoles) {
  for_random_eyes(9, beside_holes, expect_same_as_plain);
}

// Planes, some of them broken, and whole heights: lines of sight graze posts and edges.
Terrain of_planes(Random& random, SurfaceModel model) {
  const int columns = random.integer(8, 40);
  const int rows = random.integer(8, 40);
  const int by_column = random.integer(-3, 3);
  const int by_row = random.integer(-3, 3);
  const bool roof = random.chance(0.5);
  const auto grid = std::make_shared<const HeightGrid>(make_grid(columns, rows, [&](int c, int r) {
    if (random.chance(0.02)) return static_cast<double>(kVoid);
    return roof ? std::abs(c - columns / 2) * by_column + std::abs(r - rows / 2) * by_row
                : c * by_column + r * by_row + 0.0;
  }));
  const glm::dvec2 eye_uv(0.5 * random.integer(0, 2 * columns - 2),
                          0.5 * random.integer(0, 2 * rows - 2));
  const double half = std::sqrt(0.5);
  const glm::dmat2 jacobian =
      random.chance(0.5) ? glm::dmat2(1, 0, 0, -1) : glm::dmat2(half, half, half, -half) / 20.6;
  const auto map = std::make_shared<AffineGroundMap>(eye_uv, jacobian, glm::ivec2(columns, rows));
  return raised(Terrain({{grid, map}}, VerticalFrame{}, model), random.integer(0, 20));
}

TEST(PostSight, IsThatOfARayAPostWhereLinesOfSightGraze) {
  Random random(10);
  for (int i = 0; i < fewer_if_sanitized(400); ++i)
    expect_same_as_plain(of_planes(random, SurfaceModel::hyperboloid), random.integer(0, 2));
}

TEST(PostSight, IsThatOfARayAPostWhereTracksBend) {
  for_random_eyes(3, random_parabolic_terrain, expect_same_as_plain);
  for_random_eyes(4, random_bent_terrain, expect_same_as_plain);
}

TEST(PostSight, IsThatOfARayAPostOverSeveralGrids) {
  for_random_eyes(5, random_layers, expect_same_as_plain);
}

TEST(PostSight, IsTheSameUnderEveryInstructionSet) {
  Random random(6);
  for (int i = 0; i < 5; ++i) {
    const Terrain terrain = raised(random_parabolic_terrain(random, SurfaceModel::hyperboloid), 3);
    const Seen plain = posts_that_see_eye(terrain, first_grid(terrain), {.plain = true});
    under_every_instruction_set(
        [&] { EXPECT_EQ(posts_that_see_eye(terrain, first_grid(terrain)), plain); });
  }
}

TEST(PostSight, IsTheSameForAnyNumberOfThreads) {
  Random random(7);
  const Terrain terrain =
      raised(random_terrain(random, SurfaceModel::hyperboloid, Position::general), 3);
  const HeightGrid& grid = first_grid(terrain);
  const Seen one = posts_that_see_eye(terrain, grid, {.threads = 1});
  for (const int threads : {2, 3, 8})
    EXPECT_EQ(posts_that_see_eye(terrain, grid, {.threads = threads}), one);
}

std::vector<int> all_columns(const HeightGrid& grid) {
  std::vector<int> columns(static_cast<std::size_t>(grid.columns));
  std::iota(columns.begin(), columns.end(), 0);
  return columns;
}

// How far the line to an observer stays above the ground at the least, all the way; and the scale
// of what it is computed from.
struct Clearance {
  oracle::Real least_m = std::numeric_limits<oracle::Real>::infinity();
  oracle::Real scale_m = 1;
};

Clearance clearance(const Terrain& terrain, glm::dvec2 ground_m, double scene_height_m) {
  const glm::dvec3 observer_m(
      ground_m,
      static_cast<double>(oracle::z_m(terrain.frame(), ground_m.x, ground_m.y, scene_height_m)));
  const oracle::Profile profile =
      oracle::profile(terrain, {{0, 0, 0}, observer_m, glm::length(observer_m)});
  Clearance found;
  found.scale_m = std::abs(scene_height_m) + terrain.height_bound_m() + glm::length(ground_m);
  for (const oracle::Span& span : profile.spans)
    for (const oracle::Real t : {span.from_t, span.to_t})
      found.least_m = std::min(found.least_m, profile.clearance_m(span, t));
  return found;
}

TEST(PostSight, AgreesWithBruteForceInLongDouble) {
  Random random(8);
  int seen_posts = 0;
  int hidden_posts = 0;
  for (int i = 0; i < 60; ++i) {
    const Terrain terrain = raised(general(random, SurfaceModel::hyperboloid), 20);
    const HeightGrid& grid = first_grid(terrain);
    const double observer_m = 1.6;
    const Seen seen = posts_that_see_eye(terrain, grid, {.observer_m = observer_m});
    for (int row = 0; row < grid.rows; ++row) {
      const std::vector<PostPlace> places = places_in_row(terrain, grid, row, all_columns(grid));
      for (int column = 0; column < grid.columns; ++column) {
        if (std::isnan(grid.at(column, row))) continue;
        const Clearance least =
            clearance(terrain, places[static_cast<std::size_t>(column)].ground_m,
                      terrain.frame().z_scale * grid.at(column, row) + observer_m);
        if (std::fabs(least.least_m) < 1e-9L * least.scale_m) continue;
        const bool is_seen = seen[static_cast<std::size_t>(row * grid.columns + column)] != 0;
        EXPECT_EQ(is_seen, least.least_m > 0) << column << ' ' << row;
        ++(is_seen ? seen_posts : hidden_posts);
      }
    }
  }
  EXPECT_GT(seen_posts, 3000);
  EXPECT_GT(hidden_posts, 3000);
}

// A ball of 1 m between the eye and one of the observers, 2 m before him.
TEST(PostSight, IsHiddenByObjectsAllTheWayToTheObserver) {
  const Terrain terrain = make_terrain(
      make_grid(21, 3, [](int, int) { return 0; }),
      {.eye_uv = {0, 1}, .spacing_m = {10, 10}, .eye_height_m = 1.6}, SurfaceModel::hyperboloid);
  const ObjectList ball({std::make_shared<Sphere>(glm::dvec3(98, 0, 0), 1)});
  const Seen seen = posts_that_see_eye(terrain, first_grid(terrain), {.objects = &ball});
  for (std::size_t column = 0; column < 21; ++column)
    EXPECT_EQ(seen[21 + column], column < 10 ? 1 : 0) << column;
}

TEST(PostSight, HasNoSightWithoutAHeight) {
  const Terrain terrain =
      make_terrain(make_grid(9, 9, [](int c, int r) { return c == 2 && r == 3 ? kVoid : 0.0; }),
                   {.eye_uv = {4, 4}, .eye_height_m = 10}, SurfaceModel::hyperboloid);
  const Seen seen = posts_that_see_eye(terrain, first_grid(terrain));
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), 80);
  EXPECT_EQ(seen[3 * 9 + 2], 0);
}

TEST(PostSight, OfAnEyeUnderTheGroundIsNone) {
  const Terrain terrain =
      make_terrain(make_grid(9, 9, [](int, int) { return 5.0; }),
                   {.eye_uv = {4, 4}, .eye_height_m = 4.9}, SurfaceModel::hyperboloid);
  const Seen seen = posts_that_see_eye(terrain, first_grid(terrain));
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), 0);
}

// On the line between them, with a hole on the other side.
TEST(PostSight, OfAnEyeUnderTheEdgeOfTheGroundIsNone) {
  const Terrain terrain =
      make_terrain(make_grid(9, 9, [](int c, int r) { return c == 5 && r == 4 ? kVoid : 5.0; }),
                   {.eye_uv = {4, 4.5}, .eye_height_m = 4.9}, SurfaceModel::hyperboloid);
  for (const bool plain : {false, true})
    EXPECT_EQ(posts_that_see_eye(terrain, first_grid(terrain), {.plain = plain}), Seen(81, 0));
}

TEST(PostSight, ReachesAnEyeBesideTheGridOverItsEdge) {
  // A wall in the middle of the grid hides its far side; the eye is left of it.
  const Terrain terrain =
      make_terrain(make_grid(9, 5, [](int c, int) { return c == 4 ? 50.0 : 0.0; }),
                   {.eye_uv = {-30, 2}, .eye_height_m = 10}, SurfaceModel::hyperboloid);
  const Seen seen = posts_that_see_eye(terrain, first_grid(terrain));
  for (std::size_t column = 0; column < 9; ++column)
    EXPECT_EQ(seen[2 * 9 + column], column <= 4 ? 1 : 0);
}

TEST(PostSight, IsFreeOnTheSmallestGridAndUnderTheEye) {
  const Terrain terrain =
      make_terrain(make_grid(2, 2, [](int c, int) { return 10.0 * c; }),
                   {.eye_uv = {1, 1}, .eye_height_m = 10}, SurfaceModel::hyperboloid);
  EXPECT_EQ(posts_that_see_eye(terrain, first_grid(terrain)), Seen(4, 1));
}

}  // namespace
}  // namespace terrview

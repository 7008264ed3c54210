// One test per promise of terrain/sight_sweep.h: what it decides, rays say too. Small grids and odd
// maps are in tests/render/post_sight_test.cpp.
#include "terrain/sight_sweep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numeric>
#include <vector>

#include "terrain/post_sight_lines.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/parabolic_map.h"
#include "tests/support/random_scene.h"
#include "tests/support/sanitized.h"
#include "tests/support/scenes.h"

namespace terrview {
namespace {

constexpr double kSpacing_m = 30;
constexpr double kObserver_m = 1.6;

using Fates = std::vector<std::uint8_t>;

// Hills of a few sizes, and noise; voids where `holes`.
HeightGrid hills(int columns, int rows, bool holes) {
  Random random(11);
  return make_grid(columns, rows, [&](int column, int row) {
    if (holes && random.chance(0.001)) return static_cast<double>(kVoid);
    return 150 * std::sin(column * 0.031) * std::cos(row * 0.023 + 1) +
           40 * std::sin(column * 0.17 + row * 0.11) + random.uniform(0, 3);
  });
}

VerticalFrame earth(double eye_height_m) {
  VerticalFrame frame;
  frame.eye_height_m = eye_height_m;
  frame.north_curvature_per_m = 1 / 6.36e6;
  frame.east_curvature_per_m = 1 / 6.39e6;
  frame.refraction = 0.13;
  return frame;
}

Terrain over(HeightGrid grid, std::shared_ptr<const GroundMap> map, double eye_height_m) {
  return {{{std::make_shared<HeightGrid>(std::move(grid)), std::move(map)}},
          earth(eye_height_m),
          SurfaceModel::hyperboloid};
}

Terrain straight(bool holes) {
  constexpr double kTurn = 0.3;
  const glm::dmat2 jacobian{std::cos(kTurn) / kSpacing_m, std::sin(kTurn) / kSpacing_m,
                            std::sin(kTurn) / kSpacing_m, -std::cos(kTurn) / kSpacing_m};
  const auto map =
      std::make_shared<AffineGroundMap>(glm::dvec2(250.4, 200.8), jacobian, glm::ivec2(640, 600));
  return over(hills(640, 600, holes), map, 240);
}

Terrain bent(bool holes) {
  const auto map = std::make_shared<ParabolicGroundMap>(glm::dvec2(280.3, 330), kSpacing_m, 4e-7,
                                                        1.4 * 400 * kSpacing_m);
  return over(hills(600, 640, holes), map, 240);
}

// Spikes of ground from below the eye to above it, on grids so small that every post is near.
Terrain rough(Random& random, double bend_per_m) {
  constexpr int kPosts = 32;
  const double height_m = random.log_uniform(3, 300);
  HeightGrid grid = make_grid(kPosts, kPosts, [&](int, int) {
    return random.chance(0.01) ? static_cast<double>(kVoid)
                               : height_m * std::pow(random.uniform(0, 1), 3);
  });
  const glm::dvec2 eye_uv(random.uniform(8, 24), random.uniform(8, 24));
  const double turn = random.uniform(0, 6.3);
  const glm::dmat2 jacobian{std::cos(turn) / kSpacing_m, std::sin(turn) / kSpacing_m,
                            std::sin(turn) / kSpacing_m, -std::cos(turn) / kSpacing_m};
  std::shared_ptr<const GroundMap> map =
      std::make_shared<AffineGroundMap>(eye_uv, jacobian, glm::ivec2(kPosts));
  if (bend_per_m > 0)
    map = std::make_shared<ParabolicGroundMap>(eye_uv, kSpacing_m, bend_per_m, 100 * kSpacing_m);
  return over(std::move(grid), map, height_m * random.log_uniform(0.1, 10) + 1);
}

Fates sweep(const Terrain& terrain) {
  const HeightGrid& grid = *terrain.layers()[0].grid;
  EXPECT_TRUE(SightSweep::serves(terrain, grid));
  Fates fates(grid.heights_m.size(), kUndecided);
  const SightSweep sweep(terrain, kObserver_m);
  for (int side = 0; side < SightSweep::kSides; ++side)
    for (int part = 0; part < SightSweep::kParts; ++part) sweep.run(side, part, fates);
  return fates;
}

void expect_as_rays_say(const Terrain& terrain, const Fates& fates, int row_step) {
  const HeightGrid& grid = *terrain.layers()[0].grid;
  std::vector<int> columns(static_cast<std::size_t>(grid.columns));
  std::iota(columns.begin(), columns.end(), 0);
  for (int row = 0; row < grid.rows; row += row_step) {
    const std::vector<PostPlace> places = places_in_row(terrain, grid, row, columns);
    for (const int column : columns) {
      const std::uint8_t fate = fates[static_cast<std::size_t>(row * grid.columns + column)];
      const double height_m = grid.at(column, row);
      if (fate == kUndecided) continue;
      if (std::isnan(height_m)) {
        EXPECT_EQ(fate, kHidden);
        continue;
      }
      const auto line = line_of_sight(terrain.frame(), places[static_cast<std::size_t>(column)],
                                      {column, row}, height_m + kObserver_m);
      ASSERT_EQ(fate, !line || !terrain.occluded(*line) ? kSeen : kHidden) << column << ' ' << row;
    }
  }
}

TEST(SightSweep, DecidesAsRaysWhereTracksAreStraight) {
  for (const bool holes : {false, true}) {
    const Terrain terrain = straight(holes);
    expect_as_rays_say(terrain, sweep(terrain), 3);
  }
}

TEST(SightSweep, DecidesAsRaysWhereTracksBend) {
  for (const bool holes : {false, true}) {
    const Terrain terrain = bent(holes);
    expect_as_rays_say(terrain, sweep(terrain), 3);
  }
}

TEST(SightSweep, DecidesAsRaysNearTheEye) {
  Random random(5);
  int swept = 0;
  for (int i = 0; i < fewer_if_sanitized(750); ++i) {
    const Terrain terrain = rough(random, /*bend_per_m=*/i % 5 == 0 ? 3e-4 : 0);
    const auto ground = terrain.ground_at({0, 0});
    if (!ground || ground->scene_height_m >= terrain.frame().eye_height_m) continue;
    ++swept;
    expect_as_rays_say(terrain, sweep(terrain), 1);
  }
  EXPECT_GT(swept, fewer_if_sanitized(500));
}

TEST(SightSweep, DecidesAsRaysUnderEveryInstructionSet) {
  const Terrain terrain = straight(false);
  under_every_instruction_set([&] { expect_as_rays_say(terrain, sweep(terrain), 17); });
}

// Though the ground is as rough as observers are tall.
TEST(SightSweep, LeavesFewPostsUndecided) {
  for (const Terrain& terrain : {straight(false), bent(false)}) {
    const Fates fates = sweep(terrain);
    const auto share = [&](std::uint8_t fate) {
      return static_cast<double>(std::count(fates.begin(), fates.end(), fate)) /
             static_cast<double>(fates.size());
    };
    EXPECT_LT(share(kUndecided), 0.2);
    EXPECT_GT(share(kSeen), 0.1);
    EXPECT_GT(share(kHidden), 0.1);
  }
}

}  // namespace
}  // namespace terrview

#include "terrain/column_tracer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <glm/geometric.hpp>

#include "terrain/terrain.h"
#include "tests/support/expectations.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/random_scene.h"
#include "tests/support/scenes.h"

namespace terrview {
namespace {

// Azimuths anywhere and along the lines of the grid; rises steep, level and nearly so.
ColumnView random_view(Random& random, const Terrain& terrain, Position position) {
  ColumnView view;
  const int columns = random.integer(1, 20);
  const int rows = random.integer(1, 40);
  while (static_cast<int>(view.across.size()) < columns) {
    const glm::dvec2 across(random_ray(random, terrain, position).direction);
    if (glm::length(across) > 1e-6) view.across.push_back(across);
  }
  for (int row = 0; row < rows; ++row) {
    const double length = glm::length(view.across.front());
    view.rise.push_back(random.chance(0.1) ? 0
                                           : length * random.sign() * random.log_uniform(1e-7, 30));
  }
  std::sort(view.rise.rbegin(), view.rise.rend());
  return view;
}

// Hits, all equal to those of single rays. With a `front`, by it.
int expect_hits_of_single_rays(const Terrain& terrain, const EyeFront* front,
                               const ColumnView& view, int first, int count) {
  const auto rows = view.rise.size();
  std::vector<ColumnHit> hits(static_cast<std::size_t>(count) * rows);
  TraceCounts counts;
  if (front)
    trace_columns(*front, view, first, count, hits, counts);
  else
    trace_columns(terrain, view, first, count, hits, counts);
  int met = 0;
  for (int i = 0; i < count; ++i) {
    for (std::size_t row = 0; row < rows; ++row) {
      const Ray ray{
          .direction = {view.across[static_cast<std::size_t>(first + i)], view.rise[row]}};
      const auto expected = terrain.first_hit(ray);
      const ColumnHit& found = hits[static_cast<std::size_t>(i) * rows + row];
      EXPECT_EQ(found.g_m >= 0, expected.has_value()) << oracle::to_string(ray);
      if (!expected || found.g_m < 0) continue;
      expect_same_hit(column_hit(view, first + i, static_cast<int>(row), found), *expected, ray);
      ++met;
    }
  }
  return met;
}

// Hits by the plain walk and by a front.
struct Met {
  int plain = 0;
  int by_front = 0;
};

// Every column at once, and then a part of them.
template <class MakeTerrain>
Met expect_same_bits(std::uint64_t seed, Position position, const MakeTerrain& make) {
  Random random(seed);
  Met met;
  for (int i = 0; i < 300 && !testing::Test::HasFailure(); ++i) {
    const Terrain terrain = make(random);
    if (!has_columns(terrain)) continue;
    const ColumnView view = random_view(random, terrain, position);
    const int columns = static_cast<int>(view.across.size());
    met.plain += expect_hits_of_single_rays(terrain, nullptr, view, 0, columns);
    const int first = random.integer(0, columns - 1);
    const int count = random.integer(1, columns - first);
    expect_hits_of_single_rays(terrain, nullptr, view, first, count);
    if (!EyeFront::serves(terrain)) continue;
    const EyeFront front(terrain, {.wedge_rad = random.log_uniform(1e-3, 1)});
    met.by_front += expect_hits_of_single_rays(terrain, &front, view, 0, columns);
    expect_hits_of_single_rays(terrain, &front, view, first, count);
    EXPECT_FALSE(testing::Test::HasFailure()) << "seed " << seed << ", terrain " << i;
  }
  EXPECT_GT(met.plain, 5000);
  return met;
}

TEST(TraceColumns, HasTheHitsOfSingleRaysBitForBit) {
  const Met met = expect_same_bits(1, Position::general, [](Random& random) {
    return random_terrain(random, SurfaceModel::hyperboloid, Position::general);
  });
  EXPECT_EQ(met.by_front, met.plain);
}

TEST(TraceColumns, HasThemThroughPostsAndAlongLines) {
  const Met met = expect_same_bits(2, Position::special, [](Random& random) {
    return random_terrain(random, SurfaceModel::hyperboloid, Position::special);
  });
  EXPECT_EQ(met.by_front, met.plain);
}

TEST(TraceColumns, HasThemOnBentTracks) {
  const Met met = expect_same_bits(6, Position::general, [](Random& random) {
    return random_parabolic_terrain(random, SurfaceModel::hyperboloid);
  });
  EXPECT_EQ(met.by_front, met.plain);
}

TEST(TraceColumns, HasThemOnTracksThatNoFrontServes) {
  const Met met = expect_same_bits(3, Position::general, [](Random& random) {
    return random_bent_terrain(random, SurfaceModel::hyperboloid);
  });
  EXPECT_EQ(met.by_front, 0);
}

// Ties: from a post through post after post, where columns and rows are crossed at once.
TEST(TraceColumns, HasThemAlongDiagonalsFromAPost) {
  const auto rough = [](int c, int r) { return 300 * std::sin(1.7 * c + 0.3 * r * c) + 40 * r; };
  for (const double above_m : {0.0, 500.0}) {
    const Place place{
        .eye_uv = {9, 11}, .spacing_m = {60, 90}, .eye_height_m = float(rough(9, 11)) + above_m};
    const Terrain terrain =
        make_terrain(make_grid(40, 40, rough), place, SurfaceModel::hyperboloid);
    ColumnView view;
    for (int i = -5; i <= 5; ++i)
      for (int j = -5; j <= 5; ++j)
        if (i != 0 || j != 0) view.across.emplace_back(60 * i, 90 * j);
    for (int i = 0; i < 100; ++i) view.rise.push_back(100 - 3 * i);
    const int columns = static_cast<int>(view.across.size());
    expect_hits_of_single_rays(terrain, nullptr, view, 0, columns);
    const EyeFront front(terrain, {});
    expect_hits_of_single_rays(terrain, &front, view, 0, columns);
  }
}

TEST(TraceColumns, HasThemUnderEveryInstructionSet) {
  under_every_instruction_set([] {
    expect_same_bits(5, Position::general, [](Random& random) {
      return random_terrain(random, SurfaceModel::hyperboloid, Position::general);
    });
  });
}

TEST(TraceColumns, WalksEachColumnOnce) {
  const Terrain terrain = make_terrain(
      make_grid(200, 200, [](int c, int r) { return 5 * std::sin(c * 0.3 + r * 0.2); }),
      {.eye_uv = {100.3, 100.4}, .spacing_m = {30, 30}, .eye_height_m = 200},
      SurfaceModel::hyperboloid);
  ColumnView view;
  for (int i = 0; i < 64; ++i) view.across.emplace_back(0.01 * (i - 32), 1);
  for (int j = 0; j < 500; ++j) view.rise.push_back(-0.002 * (j + 1));
  TraceCounts counts;
  std::vector<ColumnHit> hits(64 * 500);
  trace_columns(terrain, view, 0, 64, hits, counts);
  // At most the cells of a column and one test a ray more.
  EXPECT_LE(counts.tests, 64 * (2 * 200 + 500));
}

}  // namespace
}  // namespace terrview

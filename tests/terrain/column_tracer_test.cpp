// Promises of terrain/column_tracer.h.
#include "terrain/column_tracer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <hwy/targets.h>

#include "tests/support/random_scene.h"
#include "tests/support/scenes.h"

namespace terrview {
namespace {

// Columns over some angle, along grid lines in special position; rows from steeply down to up.
ColumnView random_view(Random& random) {
  ColumnView view;
  const int columns = random.integer(1, 21);
  const int rows = random.integer(1, 40);
  const double quarter = std::numbers::pi / 2;
  const bool special = random.chance(0.3);
  const double heading = special ? quarter * random.integer(0, 3) : random.uniform(0, 4 * quarter);
  const double step = random.log_uniform(1e-5, 0.3);
  for (int i = 0; i < columns; ++i) {
    const double azimuth = heading + step * (i - columns / 2);
    view.across.emplace_back(std::sin(azimuth), std::cos(azimuth));
  }
  const double spread = random.log_uniform(1e-3, 20);
  const double middle = random.uniform(-1, 0.5) * spread;
  for (int j = 0; j < rows; ++j) view.rise.push_back(middle + spread * (0.5 - (j + 0.5) / rows));
  return view;
}

std::vector<ColumnHit> traced(const Terrain& terrain, const ColumnView& view, TraceCounts& counts) {
  std::vector<ColumnHit> hits(view.across.size() * view.rise.size());
  trace_columns(terrain, view, 0, static_cast<int>(view.across.size()), hits, counts);
  return hits;
}

// Every pixel's hit against the plain tracer's, bit for bit. Returns the number of hits.
int expect_plain_hits(const Terrain& terrain, const ColumnView& view) {
  const Terrain plain(terrain.layers(), terrain.frame(), terrain.model(), Search::plain);
  TraceCounts counts;
  const std::vector<ColumnHit> hits = traced(terrain, view, counts);
  int count = 0;
  for (std::size_t i = 0; i < view.across.size(); ++i) {
    for (std::size_t j = 0; j < view.rise.size(); ++j) {
      const auto expected = plain.first_hit({{0, 0, 0}, {view.across[i], view.rise[j]}});
      const ColumnHit& hit = hits[i * view.rise.size() + j];
      EXPECT_EQ(hit.g_m >= 0, expected.has_value()) << "pixel " << i << ", " << j;
      if (!expected || hit.g_m < 0) continue;
      ++count;
      const Hit found = column_hit(view, static_cast<int>(i), static_cast<int>(j), hit);
      EXPECT_EQ(found.distance_m, expected->distance_m);
      EXPECT_EQ(found.position_m, expected->position_m);
      EXPECT_EQ(found.cell, expected->cell);
      EXPECT_EQ(found.uv, expected->uv);
    }
  }
  return count;
}

// Traces `scenes` random views over random terrains of every kind.
void expect_plain_hits_in_random_views(int scenes, std::uint64_t seed) {
  Random random(seed);
  int hits = 0;
  for (int i = 0; i < scenes && !testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE(i);
    const auto position = random.chance(0.5) ? Position::special : Position::general;
    const Terrain terrain = random.chance(0.3)
                                ? random_bent_terrain(random, SurfaceModel::hyperboloid)
                                : random_terrain(random, SurfaceModel::hyperboloid, position);
    if (!has_columns(terrain)) continue;
    hits += expect_plain_hits(terrain, random_view(random));
  }
  EXPECT_GT(hits, 10 * scenes);
}

TEST(ColumnTracer, FindsThePlainTracersHitsToTheBit) { expect_plain_hits_in_random_views(400, 1); }

TEST(ColumnTracerLong, FindsThePlainTracersHitsToTheBitInManyScenes) {
  expect_plain_hits_in_random_views(20000, 2);
}

TEST(ColumnTracer, FindsTheSameHitsUnderEveryInstructionSet) {
  const std::int64_t all = hwy::SupportedTargets();
  int tried = 0;
  for (std::int64_t rest = all; rest != 0; rest &= rest - 1) {
    const std::int64_t target = rest & -rest;
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    SCOPED_TRACE(hwy::TargetName(target));
    expect_plain_hits_in_random_views(60, 3);
    ++tried;
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  EXPECT_GE(tried, 2);
}

TEST(ColumnTracer, WalksEachColumnOnce) {
  const Terrain terrain = make_terrain(
      make_grid(200, 200, [](int c, int r) { return 5 * std::sin(c * 0.3 + r * 0.2); }),
      {.eye_uv = {100.3, 100.4}, .spacing_m = {30, 30}, .eye_height_m = 200},
      SurfaceModel::hyperboloid);
  ColumnView view;
  for (int i = 0; i < 64; ++i) view.across.emplace_back(0.01 * (i - 32), 1);
  for (int j = 0; j < 500; ++j) view.rise.push_back(-0.002 * (j + 1));
  TraceCounts counts;
  const std::vector<ColumnHit> hits = traced(terrain, view, counts);
  // At most the cells of a column and one test a ray more.
  EXPECT_LE(counts.tests, 64 * (2 * 200 + 500));
}

TEST(ColumnTracer, LeavesOtherSurfacesAndSeveralGridsToTheRays) {
  const HeightGrid grid = make_grid(4, 4, [](int, int) { return 0.0; });
  EXPECT_TRUE(has_columns(make_terrain(grid, {}, SurfaceModel::hyperboloid)));
  EXPECT_FALSE(has_columns(make_terrain(grid, {}, SurfaceModel::triangles)));
  EXPECT_FALSE(has_columns(make_terrain(grid, {}, SurfaceModel::bilinear)));
  const TerrainLayer layer = make_layer(grid, {});
  EXPECT_FALSE(has_columns(Terrain({layer, layer}, {}, SurfaceModel::hyperboloid)));
}

}  // namespace
}  // namespace terrview

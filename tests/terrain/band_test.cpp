// The band surface in closed form: rows alone, or columns, break its chords.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "terrain/grid_walk.h"
#include "tests/support/expectations.h"

namespace terrview {
namespace {

// Post (c, r) at x = c, y = -r.
const Place kPosts{.eye_uv = {0, 0}, .spacing_m = {1, 1}, .eye_height_m = 0};

std::vector<Span> spans_between(const HeightGrid& grid, SurfaceModel model, glm::dvec2 from_uv,
                                glm::dvec2 to_uv) {
  const TerrainLayer layer = make_layer(grid, kPosts);
  const glm::dvec2 from_m = ground_of(kPosts, from_uv);
  const glm::dvec2 way_m = ground_of(kPosts, to_uv) - from_m;
  GridWalk walk(*layer.grid, *layer.map, model, {from_m, glm::normalize(way_m)}, 0,
                glm::length(way_m));
  std::vector<Span> spans;
  for (Span span; walk.next(span);)
    if (span.has_ground) spans.push_back(span);
  return spans;
}

HeightGrid plain(int columns, int rows) {
  return make_grid(columns, rows, [](int, int) { return 0; });
}

TEST(Band, HasHalfTheSpansNearADiagonalAndAsManyAlongALine) {
  const HeightGrid grid = plain(101, 101);
  const auto count = [&](SurfaceModel model, glm::dvec2 from_uv, glm::dvec2 to_uv) {
    return spans_between(grid, model, from_uv, to_uv).size();
  };
  EXPECT_EQ(count(SurfaceModel::hyperboloid, {0.2, 0.5}, {99.6, 99.7}), 199U);
  EXPECT_EQ(count(SurfaceModel::band, {0.2, 0.5}, {99.6, 99.7}), 100U);
  EXPECT_EQ(count(SurfaceModel::hyperboloid, {50.5, 0.5}, {50.6, 99.5}), 100U);
  EXPECT_EQ(count(SurfaceModel::band, {50.5, 0.5}, {50.6, 99.5}), 100U);
  EXPECT_EQ(count(SurfaceModel::hyperboloid, {0.5, 40.5}, {99.5, 60.4}), 120U);
  EXPECT_EQ(count(SurfaceModel::band, {0.5, 40.5}, {99.5, 60.4}), 100U);
}

TEST(Band, GoesByRowsOnADiagonal) {
  auto spans = spans_between(plain(9, 9), SurfaceModel::band, {0.25, 0}, {7.75, 7.5});
  ASSERT_EQ(spans.size(), 8U);
  spans.pop_back();  // ends with the line
  for (const Span& span : spans) EXPECT_EQ(span.out.uv.y, std::round(span.out.uv.y));
}

// From row 0 to row 1 the line crosses column 1, where a ridge stands 10 m high.
HeightGrid ridge() {
  return make_grid(3, 3, [](int column, int) { return column == 1 ? 10 : 0; });
}

TEST(Band, GoesStraightOverAColumnThatItCrossesWithinARow) {
  const auto spans = spans_between(ridge(), SurfaceModel::band, {0.75, 0}, {1.5, 1.5});
  ASSERT_EQ(spans.size(), 2U);
  EXPECT_EQ(spans[0].in.height_m, 7.5);
  EXPECT_EQ(spans[0].out.height_m, 7.5);
  EXPECT_EQ(spans[0].cell, glm::ivec2(0, 0));
  EXPECT_EQ(spans[0].last_cell, glm::ivec2(1, 0));
}

// The hyperboloid climbs the ridge, the band goes through it: under a ray 8 m up.
TEST(Band, MayMissWhatTheHyperboloidMeets) {
  const Ray ray = ray_towards({0.75, 0, 8}, {1.25, -1, 8});
  expect_hit_at(make_terrain(ridge(), kPosts, SurfaceModel::hyperboloid), ray,
                std::hypot(0.05, 0.1), 1e-9);
  const Terrain band = make_terrain(ridge(), kPosts, SurfaceModel::band);
  expect_free(band, ray);
}

TEST(Band, PutsAHitIntoTheCellUnderIt) {
  const Terrain band = make_terrain(ridge(), kPosts, SurfaceModel::band);
  for (const double share : {0.2, 0.8}) {
    const glm::dvec3 at_m(0.75 + 0.5 * share, -share, 7.5);
    const auto hit = judged_hit(band, ray_towards({0.75, 0, 9}, at_m));
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->position_m.x, at_m.x, 1e-9);
    EXPECT_EQ(hit->cell, glm::ivec2(share < 0.5 ? 0 : 1, 0));
  }
}

TEST(Band, EndsAtTheColumnWhereGroundEnds) {
  const HeightGrid grid =
      make_grid(4, 3, [](int column, int) { return column == 3 ? std::nan("") : 2 * column; });
  const auto spans = spans_between(grid, SurfaceModel::band, {1.5, 0}, {2.4, 1});
  ASSERT_EQ(spans.size(), 1U);
  EXPECT_EQ(spans[0].out.uv.x, 2);
  EXPECT_EQ(spans[0].out.height_m, 4);
}

}  // namespace
}  // namespace terrview

#include "terrain/height_pyramid.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <optional>

#include "terrain/terrain.h"
#include "tests/support/expectations.h"
#include "tests/support/random_scene.h"

namespace terrview {
namespace {

TEST(HeightPyramid, BoundsThePostsOfEveryCellAndKnowsItsHoles) {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const HeightGrid grid = random_grid(random);
    const HeightPyramid pyramid(grid);
    for (int level = HeightPyramid::kFirstLevel; level <= pyramid.last_level(); ++level) {
      for (int row = 0; row < grid.rows - 1; ++row) {
        for (int column = 0; column < grid.columns - 1; ++column) {
          const HeightPyramid::Range& range = pyramid.block(level, {column, row});
          if (!grid.has_ground(column, row)) {
            EXPECT_EQ(range.lowest_m, -std::numeric_limits<float>::infinity());
          }
          for (const glm::ivec2 post : {glm::ivec2(0, 0), {1, 0}, {0, 1}, {1, 1}}) {
            const float height_m = grid.at(column + post.x, row + post.y);
            EXPECT_FALSE(height_m > range.highest_m || height_m < range.lowest_m);
          }
        }
      }
    }
  }
}

TEST(HeightPyramid, ItsLastLevelIsOneBlock) {
  for (const glm::ivec2 size : {glm::ivec2(2, 2), {9, 9}, {10, 9}, {2, 100}, {129, 40}}) {
    const HeightGrid grid =
        make_grid(size.x, size.y, [](int c, int r) { return c == 0 && r == 0 ? -5 : c + r; });
    const HeightPyramid pyramid(grid);
    const auto& all = pyramid.block(pyramid.last_level(), {size.x - 2, size.y - 2});
    EXPECT_EQ(all.lowest_m, -5);
    EXPECT_EQ(all.highest_m, static_cast<float>(size.x + size.y - 2));
  }
}

bool same_bits(const std::optional<Hit>& a, const std::optional<Hit>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return a->distance_m == b->distance_m && a->position_m == b->position_m && a->grid == b->grid &&
         a->cell == b->cell && a->uv == b->uv;
}

class PyramidSearch : public ModelTest {};

// Traces the rays of random scenes with and without the pyramid.
template <class MakeTerrain>
void expect_same_bits(std::uint64_t seed, Position position, const MakeTerrain& make) {
  Random random(seed);
  std::int64_t plain_tests = 0;
  std::int64_t tests = 0;
  for (int i = 0; i < 200; ++i) {
    const Terrain terrain = make(random);
    const Terrain plain(terrain.layers(), terrain.frame(), terrain.model(), Search::plain);
    for (int j = 0; j < 50; ++j) {
      const Ray ray = random_ray(random, terrain, position);
      TraceCounts counts;
      TraceCounts plain_counts;
      ASSERT_TRUE(same_bits(terrain.first_hit(ray, &counts), plain.first_hit(ray, &plain_counts)))
          << "seed " << seed << ", terrain " << i << ", " << oracle::to_string(ray);
      ASSERT_EQ(terrain.occluded(ray), plain.occluded(ray)) << oracle::to_string(ray);
      tests += counts.tests;
      plain_tests += plain_counts.tests;
    }
  }
  EXPECT_LT(tests, plain_tests);
}

TEST_P(PyramidSearch, HasTheHitsOfThePlainSearchBitForBit) {
  expect_same_bits(1, Position::general, [](Random& random) {
    return random_terrain(random, GetParam(), Position::general);
  });
}

TEST_P(PyramidSearch, HasThemThroughPostsAndAlongLines) {
  expect_same_bits(2, Position::special, [](Random& random) {
    return random_terrain(random, GetParam(), Position::special);
  });
}

TEST_P(PyramidSearch, HasThemOverSeveralGrids) {
  expect_same_bits(3, Position::general,
                   [](Random& random) { return random_layers(random, GetParam()); });
}

TEST_P(PyramidSearch, HasThemOnBentTracks) {
  expect_same_bits(4, Position::general,
                   [](Random& random) { return random_bent_terrain(random, GetParam()); });
}

// From posts towards posts of a plain with few hills, so that blocks are left by their corners.
TEST_P(PyramidSearch, HasThemAlongDiagonalsFromAPost) {
  const auto hills = [](int c, int r) { return (7 * c + 5 * r) % 13 == 0 ? 90 + c : 0.1 * r; };
  const HeightGrid grid = make_grid(40, 40, hills);
  int hits = 0;
  for (int eye = 0; eye < 64; ++eye) {
    const Place place{
        .eye_uv = {16 + eye % 8, 16 + eye / 8}, .spacing_m = {60, 90}, .eye_height_m = 150};
    const Terrain terrain = make_terrain(grid, place, GetParam());
    const Terrain plain(terrain.layers(), terrain.frame(), GetParam(), Search::plain);
    for (int i = -8; i <= 8; ++i) {
      for (int j = -8; j <= 8; ++j) {
        const Ray ray{{0, 0, 0}, {60 * i, 90 * j, -30}};
        EXPECT_TRUE(same_bits(terrain.first_hit(ray), plain.first_hit(ray)))
            << oracle::to_string(ray);
        hits += terrain.first_hit(ray) ? 1 : 0;
      }
    }
  }
  EXPECT_GT(hits, 5000);
}

INSTANTIATE_TEST_SUITE_P(Models, PyramidSearch, testing::ValuesIn(kSurfaceModels), model_name);

}  // namespace
}  // namespace terrview

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <optional>

#include "terrain/terrain.h"
#include "tests/support/expectations.h"
#include "tests/support/random_scene.h"

namespace terrview {
namespace {

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

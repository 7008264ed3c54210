// Bent tracks cost no more than straight ones, and give the same hits whatever is skipped.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <optional>
#include <string>

#include <glm/geometric.hpp>

#include "ingest/view_frame.h"
#include "tests/ingest/geodesy_cases.h"

namespace terrview {
namespace {

using cases::GridCase;

// Pieces of their tracks are about a hundred posts long at 48 degrees north, fewer at 79.
const GridCase kGeographic{"geo.tif",    "EPSG:4326", {6.5, 48.6},
                           1.0 / 1200.0, {900, 900},  {0.43, 0.61}};
const GridCase kFarNorth{"north.tif",  "EPSG:4326", {15, 79.5},
                         1.0 / 1200.0, {900, 600},  {0.5, 0.6}};

// Ranges of mountains, 1500 m high.
Dem mountains(const GridCase& grid) {
  Dem dem = cases::dem(grid);
  auto heights = std::make_shared<HeightGrid>(*dem.grid);
  for (int row = 0; row < heights->rows; ++row)
    for (int column = 0; column < heights->columns; ++column)
      heights->heights_m[static_cast<std::size_t>(row * heights->columns + column)] =
          static_cast<float>(600 * std::sin(0.05 * column + 0.02 * row) * std::cos(0.043 * row) +
                             150 * std::sin(0.31 * column) * std::cos(0.37 * row) + 750);
  dem.grid = heights;
  return dem;
}

ViewFrame frame(const GridCase& grid, EarthModel earth, SurfaceModel surface, Search search) {
  const EyePlace eye{.geographic = {},
                     .projected = cases::placement(grid).at(cases::eye_uv(grid)),
                     .height_m = 300,
                     .above_ground = true};
  return {{mountains(grid)}, eye, {.earth = earth, .surface = surface, .search = search}};
}

// Calls act(ray) for rays all round, from steeply down to level.
template <class Act>
void for_each_ray(const Act& act) {
  constexpr double kTurn = 6.283185307179586;
  for (int i = 0; i < 200; ++i)
    for (int j = 0; j < 20; ++j) {
      const double azimuth = kTurn * i / 200;
      act(Ray{{0, 0, 0},
              glm::normalize(glm::dvec3(std::sin(azimuth), std::cos(azimuth), -0.015 * j))});
    }
}

TraceCounts work(const ViewFrame& frame) {
  TraceCounts counts;
  for_each_ray(
      [&](const Ray& ray) { static_cast<void>(frame.terrain()->first_hit(ray, &counts)); });
  return counts;
}

class BentTrack : public testing::TestWithParam<SurfaceModel> {};

TEST_P(BentTrack, CostsHardlyMoreWorkThanTheAffineMap) {
  for (const GridCase& grid : {kGeographic, kFarNorth}) {
    const TraceCounts curved = work(frame(grid, EarthModel::curved, GetParam(), Search::pyramid));
    const TraceCounts flat = work(frame(grid, EarthModel::flat, GetParam(), Search::pyramid));
    EXPECT_LT(static_cast<double>(curved.tests + curved.nodes),
              1.5 * static_cast<double>(flat.tests + flat.nodes))
        << grid.name << ": " << curved.tests << " tests and " << curved.nodes << " nodes beside "
        << flat.tests << " and " << flat.nodes;
  }
}

TEST_P(BentTrack, HasTheSameHitsWithAndWithoutThePyramidBitForBit) {
  for (const GridCase& grid : {kGeographic, kFarNorth}) {
    const ViewFrame fast = frame(grid, EarthModel::curved, GetParam(), Search::pyramid);
    const ViewFrame plain = frame(grid, EarthModel::curved, GetParam(), Search::plain);
    int hits = 0;
    for_each_ray([&](const Ray& ray) {
      const std::optional<Hit> a = fast.terrain()->first_hit(ray);
      const std::optional<Hit> b = plain.terrain()->first_hit(ray);
      ASSERT_EQ(a.has_value(), b.has_value());
      if (!a) return;
      ++hits;
      EXPECT_EQ(a->distance_m, b->distance_m);
      EXPECT_EQ(a->uv, b->uv);
      EXPECT_EQ(a->cell, b->cell);
    });
    EXPECT_GT(hits, 1000);
  }
}

INSTANTIATE_TEST_SUITE_P(Models, BentTrack, testing::ValuesIn(kSurfaceModels),
                         [](const auto& model) -> std::string { return name_of(model.param); });

}  // namespace
}  // namespace terrview

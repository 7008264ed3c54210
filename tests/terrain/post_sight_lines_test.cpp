// Where posts lie: terrain/post_sight_lines.h. The lines to them are in
// tests/render/post_sight_test.cpp.
#include "terrain/post_sight_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <vector>

#include <glm/geometric.hpp>

#include "tests/support/parabolic_map.h"
#include "tests/support/scenes.h"

namespace terrview {
namespace {

constexpr int kColumns = 21;
constexpr double kSpacing_m = 10;

std::shared_ptr<const HeightGrid> level_grid() {
  return std::make_shared<const HeightGrid>(make_grid(kColumns, 3, [](int, int) { return 0; }));
}

std::vector<PostPlace> places_in_first_row(const Terrain& terrain) {
  std::vector<int> columns(kColumns);
  std::iota(columns.begin(), columns.end(), 0);
  return places_in_row(terrain, *terrain.layers()[0].grid, 0, columns);
}

TEST(PlacesInRow, AreTheNearerOnesWhereTwoLayersAreOfOneGrid) {
  const auto grid = level_grid();
  const auto map_from = [](double eye_u) {
    return std::make_shared<AffineGroundMap>(glm::dvec2(eye_u, 0),
                                             glm::dmat2(1 / kSpacing_m, 0, 0, -1 / kSpacing_m),
                                             glm::ivec2(kColumns, 3));
  };
  const TerrainLayer east{grid, map_from(-3)};
  const TerrainLayer west{grid, map_from(kColumns + 3)};
  for (const auto& layers : {std::vector{east, west}, std::vector{west, east}}) {
    const auto places =
        places_in_first_row(Terrain(layers, VerticalFrame{}, SurfaceModel::hyperboloid));
    for (int column = 0; column < kColumns; ++column) {
      const PostPlace& place = places[static_cast<std::size_t>(column)];
      const double away_m = kSpacing_m * std::min(column + 3, kColumns + 3 - column);
      EXPECT_NEAR(glm::length(place.ground_m), away_m, 1e-5) << column;
      EXPECT_EQ(place.map, (column + 3 < kColumns + 3 - column ? east : west).map.get());
    }
  }
}

TEST(PlacesInRow, AreNowhereBeyondTheReachOfTheEye) {
  const auto map = std::make_shared<ParabolicGroundMap>(glm::dvec2(0), kSpacing_m, 1e-6,
                                                        /*reach_m=*/94.9);
  const auto places = places_in_first_row(
      Terrain({{level_grid(), map}}, VerticalFrame{}, SurfaceModel::hyperboloid));
  for (int column = 0; column < kColumns; ++column)
    EXPECT_EQ(places[static_cast<std::size_t>(column)].map != nullptr, column <= 9) << column;
}

}  // namespace
}  // namespace terrview

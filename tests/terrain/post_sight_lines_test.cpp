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

TEST(PlacesInRow, AreTheSameWhicheverOthersAreAskedFor) {
  const glm::dvec2 eye_uv(7.3, 1.4);
  const glm::dmat2 turned = glm::dmat2(0.6, 0.8, 0.8, -0.6) / kSpacing_m;
  for (const std::shared_ptr<const GroundMap>& map : std::vector<std::shared_ptr<const GroundMap>>{
           std::make_shared<AffineGroundMap>(eye_uv, turned, glm::ivec2(kColumns, 3)),
           std::make_shared<ParabolicGroundMap>(eye_uv, kSpacing_m, 1e-4, 500.0)}) {
    const Terrain terrain({{level_grid(), map}}, VerticalFrame{}, SurfaceModel::hyperboloid);
    const auto together = places_in_first_row(terrain);
    for (int column = 0; column < kColumns; ++column) {
      const PostPlace alone =
          places_in_row(terrain, *terrain.layers()[0].grid, 0, std::vector{column})[0];
      EXPECT_EQ(alone.ground_m, together[static_cast<std::size_t>(column)].ground_m) << column;
      EXPECT_EQ(alone.map, map.get());
    }
  }
}

// Two patches whose values differ a little where they meet, as those that stand for curved maps do.
class PatchedMap final : public GroundMap {
 public:
  [[nodiscard]] glm::dvec2 to_grid(glm::dvec2 ground_m) const override {
    const double gap = ground_m.x > 0 ? kGap_cells : -kGap_cells;
    return glm::dvec2(kColumns / 2 + gap, 1) + jacobian(ground_m) * ground_m;
  }
  [[nodiscard]] glm::dmat2 jacobian(glm::dvec2 /*ground_m*/) const override {
    return {1 / kSpacing_m, 0, 0, -1 / kSpacing_m};
  }
  [[nodiscard]] double piece_end_m(const GroundLine& /*line*/, double /*from_m*/,
                                   double limit_m) const override {
    return limit_m;
  }
  [[nodiscard]] double reach_m() const override { return 500; }

  static constexpr double kGap_cells = 1e-5;
};

TEST(PlacesInRow, AreThereWherePatchesOfAMapMeet) {
  const Terrain terrain({{level_grid(), std::make_shared<PatchedMap>()}}, VerticalFrame{},
                        SurfaceModel::hyperboloid);
  const auto places = places_in_first_row(terrain);
  for (int column = 0; column < kColumns; ++column) {
    const PostPlace& place = places[static_cast<std::size_t>(column)];
    ASSERT_NE(place.map, nullptr) << column;
    EXPECT_NEAR(place.ground_m.x, kSpacing_m * (column - kColumns / 2),
                3 * PatchedMap::kGap_cells * kSpacing_m);
  }
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

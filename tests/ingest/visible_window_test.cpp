// Promises of ingest/visible_window.h.
#include "ingest/visible_window.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "tests/ingest/geodesy_cases.h"

namespace terrview {
namespace {

using cases::eye_point;
using cases::grid_cases;
using cases::GridCase;
using cases::Oracle;
using cases::placement;
using cases::transform;

constexpr double kPi = std::numbers::pi;

DemHeader header_of(const GridCase& grid) {
  DemHeader header;
  header.name = grid.name;
  header.columns = grid.posts.x;
  header.rows = grid.posts.y;
  header.placement = placement(grid);
  header.crs_wkt = grid.crs;
  return header;
}

bool holds(const PostWindow& window, glm::dvec2 uv) {
  const auto [column, row, width, height] = window;
  return uv.x >= column && uv.y >= row && uv.x <= column + width - 1 && uv.y <= row + height - 1;
}

double share_of(const PostWindow& window, const DemHeader& header) {
  return static_cast<double>(window[2]) * window[3] / header.columns / header.rows;
}

class VisibleWindow : public testing::TestWithParam<GridCase> {};

TEST_P(VisibleWindow, HoldsEveryPostOfTheSectorAndOfItsShadows) {
  const GridCase& grid = GetParam();
  const DemHeader header = header_of(grid);
  const GeoPoint eye = eye_point(grid, *transform(grid));
  const Oracle oracle(grid, eye);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int i = 0; i < 20; ++i) {
    ViewSector sector{.eye = eye, .heading_rad = 2 * kPi * uniform(random)};
    sector.half_width_rad = 0.05 + 1.2 * uniform(random);
    sector.reach_m = 200'000 * uniform(random);
    sector.sun_azimuth_rad = 2 * kPi * uniform(random);
    sector.shadow_m = 20'000 * uniform(random);
    const PostWindow window = visible_window(header, sector);
    for (int j = 0; j < 200; ++j) {
      const double azimuth = sector.heading_rad + sector.half_width_rad * (2 * uniform(random) - 1);
      const glm::dvec2 seen_m =
          sector.reach_m * uniform(random) * glm::dvec2(std::sin(azimuth), std::cos(azimuth));
      const glm::dvec2 shading_m = seen_m + sector.shadow_m * uniform(random) *
                                                glm::dvec2(std::sin(sector.sun_azimuth_rad),
                                                           std::cos(sector.sun_azimuth_rad));
      for (const glm::dvec2 ground_m : {seen_m, shading_m}) {
        const glm::dvec2 uv = oracle.to_grid(ground_m);
        const bool on_grid =
            uv.x >= 0 && uv.y >= 0 && uv.x <= header.columns - 1 && uv.y <= header.rows - 1;
        if (on_grid) {
          EXPECT_TRUE(holds(window, uv)) << uv.x << ", " << uv.y;
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, VisibleWindow, testing::ValuesIn(grid_cases()),
                         [](const auto& tested) {
                           std::string name;
                           for (const char c : tested.param.name)
                             if (std::isalnum(static_cast<unsigned char>(c)) != 0) name += c;
                           return name;
                         });

GridCase utm() {
  return {"UTM", "EPSG:32632", {300'000, 5'600'000}, 30, {20'000, 20'000}, {0.5, 0.5}};
}

TEST(VisibleWindowSize, IsThatOfTheSectorAndNotOfTheFile) {
  const GridCase grid = utm();
  ViewSector sector{.eye = eye_point(grid, *transform(grid))};
  sector.half_width_rad = 0.3;
  sector.reach_m = 60'000;
  EXPECT_LT(share_of(visible_window(header_of(grid), sector), header_of(grid)), 0.02);
}

TEST(VisibleWindowSize, IsTheWholeFileWhereNothingIsKnown) {
  const GridCase grid = utm();
  ViewSector sector{.eye = eye_point(grid, *transform(grid)), .half_width_rad = 0.3};
  sector.reach_m = 60'000;
  DemHeader header = header_of(grid);
  header.crs_wkt.clear();
  EXPECT_EQ(share_of(visible_window(header, sector), header), 1);
}

}  // namespace
}  // namespace terrview

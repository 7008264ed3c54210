// Where viewsheds of other programs were found wrong: each test is named after what was reported.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <GeographicLib/Geodesic.hpp>

#include "ingest/zone.h"
#include "tests/ingest/geodesy_cases.h"
#include "tests/ingest/zone_cases.h"

namespace terrview {
namespace {

using cases::laid_flat;
using cases::sea;
using cases::target_at;

constexpr double kSpacing_m = 15;

// 2 m above a mesa 30 m wide and 255 m high on a plain at 0: its edges, 15 m away, hide the plain
// up to 15 * 257 / 2 = 1927.5 m, and so in a square. (gdal#8291: GDAL hides two of its quarters.)
TEST(ZoneTraps, AMesaHidesThePlainBelowInASquare) {
  constexpr int kMiddle = 140;
  const Dem dem = laid_flat(2 * kMiddle + 1, 2 * kMiddle + 1, kSpacing_m, [](int column, int row) {
    return std::max(std::abs(column - kMiddle), std::abs(row - kMiddle)) <= 1 ? 255.0 : 0.0;
  });
  const Zone zone = visible_zone(
      {dem}, {target_at({kMiddle * kSpacing_m, kMiddle * kSpacing_m}, 257)}, {.observer_m = 0});
  for (int row = 0; row < zone.rows; ++row)
    for (int column = 0; column < zone.columns; ++column) {
      const int away = std::max(std::abs(column - kMiddle), std::abs(row - kMiddle));
      ASSERT_EQ(zone.counts[zone.index(column, row)] != 0, away <= 1 || away * kSpacing_m > 1927.5)
          << column << ' ' << row;
    }
}

// From 257 m, a mesa of 30 m whose far edge is 1702 m away hides the plain behind it up to
// 1702 * 257 / 227 = 1926.9 m.
TEST(ZoneTraps, AFarMesaHidesThePlainBehindItToWhereTheLineComesDown) {
  constexpr double kStep_m = 23;
  const Dem dem = laid_flat(101, 3, kStep_m,
                            [](int column, int) { return column >= 50 && column <= 74 ? 30 : 0; });
  const Zone zone = visible_zone({dem}, {target_at({0, kStep_m}, 257)}, {.observer_m = 0});
  for (int column = 0; column <= 100; ++column)
    EXPECT_EQ(zone.counts[zone.index(column, 1)],
              column <= 74 || column * kStep_m > 1702 * 257.0 / 227 ? 1 : 0)
        << column;
}

// Down a cliff the plain is hidden up to where the line over the edge touches it, and seen beyond.
TEST(ZoneTraps, ACliffHidesItsFoot) {
  const Dem dem = laid_flat(200, 3, 10, [](int column, int) { return column <= 20 ? 100 : 0; });
  const Zone zone = visible_zone({dem}, {target_at({100, 10}, 120)}, {.observer_m = 0});
  // Over the edge at 200 m it falls 20 m in 100 m.
  for (int column = 0; column < 200; ++column)
    EXPECT_EQ(zone.counts[zone.index(column, 1)], column <= 20 || column * 10 > 700 ? 1 : 0)
        << column;
}

// gdal#10588: one ridge, 11 km away, was looked over.
TEST(ZoneTraps, ARidgeFarAwayHidesWhatIsBehindIt) {
  constexpr double kStep_m = 90;
  const auto ridge = [](int column, int row) {
    return row == 1 && column == 122 ? 130.0 : 20.0 * std::sin(0.1 * column);
  };
  const Dem dem = laid_flat(1001, 3, kStep_m, ridge);
  const Zone zone = visible_zone({dem}, {target_at({0, kStep_m}, 100)}, {.observer_m = 1});
  for (int column = 123; column <= 1000; ++column)
    EXPECT_EQ(zone.counts[zone.index(column, 1)], 0) << column;
  EXPECT_EQ(zone.counts[zone.index(122, 1)], 1);
}

// gdal#12518: from high enough GDAL sees nothing.
TEST(ZoneTraps, FromVeryHighAllIsSeen) {
  const Dem dem = laid_flat(31, 31, 30, [](int column, int row) { return (column * row) % 7; });
  for (const double height_m : {750'366.0, 750'367.0, 1e6, 2e7}) {
    const Zone zone = visible_zone({dem}, {target_at({450, 450}, height_m)});
    EXPECT_EQ(std::count(zone.counts.begin(), zone.counts.end(), 1.0F), 31 * 31) << height_m;
  }
}

// Over the sea a tower of 60 m is seen as far as its horizon and the observer's add up to,
// sqrt(2 R / (1 - k)) (sqrt(60) + sqrt(1.6)), in every kind of coordinates (gdal#8915: in degrees
// GDAL leaves the curvature out), over the antimeridian too and in all directions, due north from
// either side (0 degrees is 360).
void expect_horizon_all_round(const cases::GridCase& grid) {
  const Dem dem = sea(grid.crs, grid.north_west, grid.spacing, grid.posts);
  const GeoPoint tower = cases::eye_point(grid, *cases::transform(grid));
  const Zone zone = visible_zone(
      {dem}, {{.geographic = tower, .projected = {}, .height_m = 60, .above_ground = false}});
  const cases::Oracle oracle(grid, tower);
  const double a = 6378137;
  const double f = 1 / 298.257223563;
  int judged = 0;
  for (int row = 0; row < zone.rows; row += 3)
    for (int column = 0; column < zone.columns; column += 3) {
      const GeoPoint post = oracle.geographic({column, row});
      double s = 0;
      double azimuth_deg = 0;
      double back_deg = 0;
      GeographicLib::Geodesic(a, f).Inverse(tower.latitude_deg, tower.longitude_deg,
                                            post.latitude_deg, post.longitude_deg, s, azimuth_deg,
                                            back_deg);
      const double sine = std::sin(tower.latitude_deg / 57.29577951308232);
      const double e2 = f * (2 - f);
      const double across = a / std::sqrt(1 - e2 * sine * sine);
      const double along = across * (1 - e2) / (1 - e2 * sine * sine);
      const double c = std::cos(azimuth_deg / 57.29577951308232);
      const double radius = 1 / (c * c / along + (1 - c * c) / across);
      const double horizon = std::sqrt(2 * radius / (1 - 0.13)) * (std::sqrt(60) + std::sqrt(1.6));
      if (std::abs(s / horizon - 1) < 2e-3) continue;
      ++judged;
      ASSERT_EQ(zone.counts[zone.index(column, row)], s < horizon ? 1 : 0)
          << grid.name << ' ' << column << ' ' << row << ' ' << s << ' ' << horizon;
    }
  EXPECT_GT(judged, 1000) << grid.name;
}

TEST(ZoneTraps, TheEarthIsRoundInEveryKindOfCoordinates) {
  expect_horizon_all_round(
      {"degrees", "EPSG:4326", {7.0, 47.4}, 1.0 / 240, {241, 193}, {0.5, 0.5}});
  expect_horizon_all_round({"UTM", "EPSG:32632", {460000, 5240000}, 300, {267, 267}, {0.5, 0.5}});
  expect_horizon_all_round(
      {"web Mercator", "EPSG:3857", {730000, 6180000}, 500, {241, 241}, {0.5, 0.5}});
}

TEST(ZoneTraps, AZoneGoesOnBeyondTheAntimeridian) {
  expect_horizon_all_round(
      {"antimeridian", "EPSG:4326", {179.5, -16.3}, 1.0 / 240, {241, 193}, {0.5, 0.5}});
  expect_horizon_all_round(
      {"antimeridian, from beside", "EPSG:4326", {179.5, -16.3}, 1.0 / 240, {241, 193}, {1, 0.5}});
}

TEST(ZoneTraps, AZoneGoesOnBeyondThePole) {
  expect_horizon_all_round(
      {"polar stereographic", "EPSG:3413", {-40000, 40000}, 300, {267, 267}, {0.5, 0.55}});
}

// What lies left and right of due north alike is seen alike, and so is what lies due north.
TEST(ZoneTraps, ZeroDegreesAre360) {
  constexpr int kMiddle = 40;
  const Dem dem = laid_flat(2 * kMiddle + 1, 2 * kMiddle + 1, 10, [](int column, int row) {
    return 30 * std::sin(std::abs(column - kMiddle) * 1.7) * std::cos(row * 2.3);
  });
  const Zone zone = visible_zone({dem}, {target_at({kMiddle * 10, kMiddle * 10}, 45)});
  int seen = 0;
  for (int row = 0; row < zone.rows; ++row)
    for (int column = 0; column <= kMiddle; ++column) {
      EXPECT_EQ(zone.counts[zone.index(column, row)],
                zone.counts[zone.index(2 * kMiddle - column, row)])
          << column << ' ' << row;
      seen += zone.counts[zone.index(column, row)] != 0 ? 1 : 0;
    }
  EXPECT_GT(seen, 500);
  EXPECT_LT(seen, 3000);
}

}  // namespace
}  // namespace terrview

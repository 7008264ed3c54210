// One test per promise of the ground maps of ingest/lay_grid.h, on every kind of coordinate system,
// against GeographicLib and PROJ used directly.
#include "ingest/lay_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <thread>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "ingest/curved_ground_map.h"
#include "terrain/error.h"
#include "terrain/eye_tracks.h"
#include "terrain/track_piece.h"
#include "tests/ingest/geodesy_cases.h"
#include "tests/ingest/ground_maps.h"

namespace terrview {
namespace {

using cases::GridCase;
using cases::Oracle;

TEST_P(GroundMaps, FindEveryPost) {
  ASSERT_EQ(laid_.size(), 1U);
  const bool affine = dynamic_cast<const AffineGroundMap*>(&map()) != nullptr;
  const bool uneven = GetParam().name == "up to the pole" || GetParam().name == "German";
  const double tolerance = affine ? GroundMap::kTrackError_cells : uneven ? 4e-3 : 2e-5;
  for (const glm::dvec2 point : ground_of_posts(2000))
    EXPECT_LT(glm::distance(map().to_grid(point), oracle_.to_grid(point)), tolerance);
}

TEST_P(GroundMaps, KnowTheirSlope) {
  for (const glm::dvec2 point : ground_of_posts(200)) {
    const double step_m = 0.5;
    const glm::dvec2 along_x = (map().to_grid(point + glm::dvec2(step_m, 0)) -
                                map().to_grid(point - glm::dvec2(step_m, 0))) /
                               (2 * step_m);
    const glm::dvec2 along_y = (map().to_grid(point + glm::dvec2(0, step_m)) -
                                map().to_grid(point - glm::dvec2(0, step_m))) /
                               (2 * step_m);
    const glm::dmat2 slope = map().jacobian(point);
    const double size = glm::length(slope[0]) + glm::length(slope[1]);
    EXPECT_LT(glm::distance(slope[0], along_x), 1e-4 * size);
    EXPECT_LT(glm::distance(slope[1], along_y), 1e-4 * size);
  }
}

TEST_P(GroundMaps, ReachEveryPost) {
  for (const glm::dvec2 point : ground_of_posts(2000))
    EXPECT_LE(glm::length(point), map().reach_m());
}

// Walks a line in pieces and hands over points of each chord with the curve's.
template <class Check>
int walk(const GroundMap& map, const Oracle& oracle, const GroundLine& line, double length_m,
         const Check& check) {
  constexpr int kSamples = 12;
  int pieces = 0;
  double from_m = 0;
  while (from_m < length_m) {
    const double to_m = map.piece_end_m(line, from_m, length_m);
    EXPECT_GT(to_m, from_m);
    EXPECT_LE(to_m, length_m);
    if (!(to_m > from_m)) return pieces;
    const glm::dvec2 start = map.to_grid(line.at(from_m));
    const glm::dvec2 end = map.to_grid(line.at(to_m));
    for (int i = 0; i <= kSamples; ++i) {
      const double share = static_cast<double>(i) / kSamples;
      const double g_m = from_m + share * (to_m - from_m);
      check(g_m, start + share * (end - start), oracle.to_grid(line.at(g_m)));
    }
    from_m = to_m;
    ++pieces;
  }
  return pieces;
}

TEST_P(GroundMaps, KeepTracksWithinTheirPromise) {
  const double length_m = std::min(map().reach_m(), 150e3);
  double worst_cells = 0;
  double worst_rad = 0;
  for (int i = 0; i < 48; ++i) {
    const GroundLine line = line_from_eye(i, 48);
    walk(map(), oracle_, line, length_m, [&](double g_m, glm::dvec2 chord, glm::dvec2 curve) {
      if (off_grid(curve) > 0) return;
      const glm::dmat2 to_ground = glm::inverse(map().jacobian(line.at(g_m)));
      const double cell_m = std::min(glm::length(to_ground[0]), glm::length(to_ground[1]));
      const glm::dvec2 error = chord - curve;
      worst_cells = std::max(worst_cells, glm::length(error));
      worst_rad = std::max(worst_rad, glm::length(to_ground * error) / std::max(g_m, cell_m));
    });
  }
  EXPECT_LE(worst_cells, GroundMap::kTrackError_cells);
  EXPECT_LE(worst_rad, 1.1 * GroundMap::kTrackError_rad);
}

TEST_P(GroundMaps, KeepTheirDistanceFromTheGrid) {
  constexpr int kSteps = 20;
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> share(0, 1);
  for (int i = 0; i < 400; ++i) {
    const double azimuth = 2 * std::numbers::pi * share(random);
    const GroundLine line{{0, 0}, {std::sin(azimuth), std::cos(azimuth)}};
    const double from_m = 0.5 * share(random) * map().reach_m();
    const double to_m = from_m + 0.5 * share(random) * map().reach_m();
    double length = 0;
    double nearest = std::numeric_limits<double>::infinity();
    const glm::dvec2 start = map().to_grid(line.at(from_m));
    glm::dvec2 uv = start;
    for (int j = 0; j <= kSteps; ++j) {
      const glm::dvec2 next =
          map().to_grid(line.at(glm::mix(from_m, to_m, static_cast<double>(j) / kSteps)));
      length += glm::distance(uv, next);
      uv = next;
      nearest =
          std::min(nearest, glm::length(glm::max(glm::dvec2(0), glm::max(uv - last_post(), -uv))));
    }
    if (length <= 1.1 * glm::distance(start, uv)) {
      EXPECT_LE(map().distance_from_grid(line, from_m, to_m), nearest + 1e-3) << azimuth;
    }
  }
}

// Those of the table, where there is one; it adds little at the knots.
TEST_P(GroundMaps, KeepTracksFromTheEyeWithinTheirPromise) {
  const GroundMap& map = this->map();
  const double length_m = std::min(map.reach_m(), 300e3);
  const glm::dvec2 eye_uv = map.to_grid({0, 0});
  for (int i = 0; i < 400; ++i) {
    const GroundLine line = line_from_eye(i, 400);
    glm::dvec2 start = eye_uv;
    for (double from_m = 0; from_m < length_m;) {
      const TrackPiece piece = track_piece(map, line, from_m, start, length_m);
      ASSERT_GT(piece.end_m, from_m);
      for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const double g_m = glm::mix(from_m, piece.end_m, share);
        const glm::dvec2 curve = oracle_.to_grid(line.at(g_m));
        const glm::dvec2 track = piece.at(g_m);
        if (off_grid(curve) <= 0) {
          EXPECT_LE(glm::distance(track, curve), GroundMap::kTrackError_cells) << g_m;
        } else if (off_grid(curve) > GroundMap::kTrackError_cells) {
          EXPECT_GT(off_grid(track), 0) << g_m;
        }
      }
      from_m = piece.end_m;
      start = piece.end;
      const glm::dvec2 knot = map.to_grid(line.at(from_m));
      if (map.eye_tracks() && off_grid(knot) <= 0) {
        EXPECT_LE(glm::distance(start, knot), 0.15 * GroundMap::kTrackError_cells) << from_m;
      }
    }
  }
}

TEST_P(GroundMaps, KeepTracksThatMissTheEyeWithinTheirPromise) {
  const double length_m = std::min(2 * map().reach_m(), 150e3);
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> turn(0, 2 * std::numbers::pi);
  double worst_cells = 0;
  for (const glm::dvec2 origin : ground_of_posts(32)) {
    const double azimuth = turn(random);
    walk(map(), oracle_, {origin, {std::sin(azimuth), std::cos(azimuth)}}, length_m,
         [&](double, glm::dvec2 chord, glm::dvec2 curve) {
           if (off_grid(curve) <= 0)
             worst_cells = std::max(worst_cells, glm::distance(chord, curve));
         });
  }
  EXPECT_LE(worst_cells, GroundMap::kTrackError_cells);
}

TEST_P(GroundMaps, KeepTracksOffTheGridWhereTheyPassBesideIt) {
  const glm::dvec2 centre = laid_[0].exact.to_ground(0.5 * last_post());
  const double size_m = glm::distance(centre, laid_[0].exact.to_ground(last_post()));
  std::mt19937_64 random(17);
  std::uniform_real_distribution<double> share(-1, 1);
  for (int i = 0; i < 1500; ++i) {
    const double azimuth = std::numbers::pi * share(random);
    const glm::dvec2 start(share(random), share(random));
    walk(map(), oracle_, {centre + 4 * size_m * start, {std::sin(azimuth), std::cos(azimuth)}},
         6 * size_m, [&](double g_m, glm::dvec2 chord, glm::dvec2 curve) {
           if (off_grid(curve) > GroundMap::kTrackError_cells) {
             EXPECT_GT(off_grid(chord), 0) << g_m;
           }
         });
  }
}

TEST_P(GroundMaps, StayOffTheGridFarAway) {
  for (int i = 0; i < 48; ++i) {
    const GroundLine line = line_from_eye(i, 48);
    for (const double share : {1.0, 1.3, 2.0, 5.0, 20.0, 50.0})
      EXPECT_GT(off_grid(map().to_grid(line.at(share * map().reach_m()))), 0) << i << " " << share;
  }
}

INSTANTIATE_TEST_SUITE_P(EveryKind, GroundMaps, testing::ValuesIn(cases::grid_cases()),
                         name_of_case);

std::vector<LaidGrid> lay(const GridCase& grid) {
  const auto crs = cases::transform(grid);
  return lay_grid({cases::eye_point(grid, *crs), crs, cases::placement(grid)}, grid.posts,
                  kSight_m);
}

TEST(LayGrid, LaysASmallProjectedGridInOnePiece) {
  const auto laid = lay({"UTM", "EPSG:32632", {350000, 5312000}, 75, {200, 300}, {0.5, 0.5}});
  EXPECT_NE(dynamic_cast<const AffineGroundMap*>(laid[0].map.get()), nullptr);
  const GroundLine line{{0, 0}, {0.6, 0.8}};
  EXPECT_EQ(laid[0].map->piece_end_m(line, 0, 20e3), 20e3);
}

TEST(LayGrid, BendsTracksOverALargeOne) {
  const auto laid = lay({"UTM", "EPSG:32632", {300000, 5400000}, 75, {1500, 1500}, {0.5, 0.5}});
  EXPECT_EQ(dynamic_cast<const AffineGroundMap*>(laid[0].map.get()), nullptr);
}

TEST(LayGrid, TakesFewPieces) {
  const auto laid = lay({"geo", "EPSG:4326", {6, 49}, 1.0 / 1200, {2401, 2401}, {0.5, 0.5}});
  const GroundLine line{{0, 0}, {0.6, 0.8}};
  int pieces = 0;
  for (double from_m = 0; from_m < 100e3; ++pieces)
    from_m = laid[0].map->piece_end_m(line, from_m, 100e3);
  EXPECT_GT(pieces, 5);
  EXPECT_LT(pieces, 30);
}

TEST(LayGrid, TabulatesTheTracksOfEyesOverItBesideItAndFarAway) {
  for (const glm::dvec2 eye_share :
       {glm::dvec2(0.5, 0.5), glm::dvec2(-0.01, 0.5), glm::dvec2(1.2, 1.3), glm::dvec2(-2, 0.5),
        glm::dvec2(2.9, -1.7)}) {
    const auto laid = lay({"geo", "EPSG:4326", {6, 49}, 1.0 / 1200, {1201, 1201}, eye_share});
    EXPECT_NE(laid[0].map->eye_tracks(), nullptr) << eye_share.x << ", " << eye_share.y;
  }
}

// From so far that such a grid lies between two directions of a coarse table.
TEST(LayGrid, KeepsTracksToSmallGridsFarAwayWithinTheirPromise) {
  const GridCase grids[] = {
      {"a", "EPSG:4326", {6.5, 48.6}, 2.7e-5, {288, 288}, {175.1, 197.2}},
      {"b", "EPSG:4326", {6.5, 48.6}, 1.018e-4, {110, 110}, {72.9, 228.1}},
  };
  std::mt19937_64 random(29);
  std::uniform_real_distribution<double> share(0, 1);
  for (const GridCase& grid : grids) {
    const LaidGrid laid = lay(grid)[0];
    const EyeTracks* tracks = laid.map->eye_tracks();
    ASSERT_NE(tracks, nullptr);
    const Oracle oracle(grid, cases::eye_point(grid, *cases::transform(grid)));
    for (int i = 0; i < 200; ++i) {
      const glm::dvec2 post = glm::dvec2(grid.posts - 1) * glm::dvec2(share(random), share(random));
      const glm::dvec2 ground_m = laid.exact.to_ground(post);
      const double g_m = glm::length(ground_m);
      const TrackPiece piece = tracks->piece(ground_m / g_m, g_m, laid.map->reach_m());
      EXPECT_LE(glm::distance(piece.at(g_m), oracle.to_grid(ground_m)),
                GroundMap::kTrackError_cells)
          << grid.name;
    }
  }
}

TEST(LayGrid, LaysAGlobalGridOnBothSidesOfItsSeam) {
  const GridCase globe{"globe", "EPSG:4326", {-180, 90}, 1.0 / 4, {1440, 721}, {0.9999, 0.25}};
  const auto laid = lay(globe);
  ASSERT_EQ(laid.size(), 2U);
  const auto crs = cases::transform(globe);
  const GeoPoint eye = cases::eye_point(globe, *crs);
  // Fifty kilometres east and west of the eye, which stands just west of the antimeridian.
  for (const double x_m : {-50e3, 50e3}) {
    const GeoPoint place = geographic_from_ground(eye, {x_m, 0});
    const glm::dvec2 expected((place.longitude_deg + 180) * 4, (90 - place.latitude_deg) * 4);
    int found = 0;
    for (const LaidGrid& side : laid)
      if (glm::distance(side.map->to_grid({x_m, 0}), expected) < 1e-4) ++found;
    EXPECT_EQ(found, 1) << x_m;
  }
}

TEST(LayGrid, LaysAGlobalGridOnceAwayFromItsSeam) {
  EXPECT_EQ(lay({"globe", "EPSG:4326", {-180, 90}, 0.25, {1440, 721}, {0.52, 0.25}}).size(), 1U);
}

TEST(LayGrid, RefusesAGridThatSurroundsAPole) {
  const GridCase globe{"globe", "EPSG:4326", {-180, 90}, 0.25, {1440, 721}, {0.5, 0.004}};
  try {
    (void)lay(globe);
    FAIL() << "laid";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("gdalwarp"), std::string::npos) << error.what();
  }
}

TEST(LayGrid, SharesAMapBetweenThreads) {
  const auto laid = lay({"geo", "EPSG:4326", {6, 49}, 1.0 / 1200, {2401, 2401}, {0.5, 0.5}});
  const auto sum = [&] {
    glm::dvec2 total(0);
    for (int i = 0; i < 1000; ++i) total += laid[0].map->to_grid({37.0 * i, -23.0 * i});
    return total;
  };
  const glm::dvec2 expected = sum();
  std::vector<glm::dvec2> sums(4);
  std::vector<std::thread> threads;
  for (glm::dvec2& result : sums) threads.emplace_back([&] { result = sum(); });
  for (std::thread& thread : threads) thread.join();
  for (const glm::dvec2& result : sums) EXPECT_EQ(result, expected);
}

}  // namespace
}  // namespace terrview

#include "terrain/wedge_edges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "terrain/eye_tracks.h"
#include "tests/support/parabolic_map.h"
#include "tests/support/random_scene.h"
#include "tests/support/scenes.h"

namespace terrview {
namespace {

// A line of the grid, and how a track crosses it: the distance, and where along the line.
struct GridLine {
  int across;  // 0: a line of equal u
  double at;
};
struct Crossing {
  std::size_t piece;
  double g_m, along;
  glm::dvec2 rate;  // across, along
};

// Piece by piece; nullopt where the track meets the line nowhere up to `to_m`, or hardly crosses
// it.
std::optional<Crossing> cross(const EyeTracks& tracks, glm::dvec2 direction, const GridLine& line,
                              double to_m) {
  const std::vector<double>& knots_m = tracks.knots_m();
  for (std::size_t i = 0; i + 1 < knots_m.size() && knots_m[i] < to_m; ++i) {
    const TrackPiece piece = tracks.piece(direction, knots_m[i], knots_m.back());
    const double rate = piece.rate[line.across];
    const double g_m = piece.begin_m + (line.at - piece.start[line.across]) / rate;
    if (!(g_m >= knots_m[i] && g_m < std::min(to_m, knots_m[i + 1]))) continue;
    if (std::abs(rate) < 0.2 * glm::length(piece.rate)) return std::nullopt;
    return Crossing{i, g_m, piece.at(g_m)[1 - line.across], {rate, piece.rate[1 - line.across]}};
  }
  return std::nullopt;
}

// How much of its margin a crossing needs, by its distance and by its place along the line.
double needed_margin(const Crossing& a, const Crossing& b, const Crossing& between, double bulge) {
  const double share = (between.along - a.along) / (b.along - a.along);
  const double g_m = a.g_m + share * (b.g_m - a.g_m);
  const double metres = std::max(std::abs(1 / a.rate.x), std::abs(1 / b.rate.x));
  const double turn = std::max(std::abs(a.rate.y / a.rate.x), std::abs(b.rate.y / b.rate.x));
  const double early_m = std::max({0.0, between.g_m - g_m, g_m / bulge - between.g_m});
  const double beside = std::max({0.0, between.along - std::max(a.along, b.along),
                                  std::min(a.along, b.along) - between.along});
  return std::max(early_m / metres, beside / (1 + turn));
}

TEST(WedgeEdges, HaveCrossingsBetweenTheirsAsNearToLinearOnesAsTheySay) {
  Random random(31);
  std::int64_t crossings = 0;
  for (const double bend_per_m : {1e-5, 2e-4})
    for (const int wedges_a_side : {60, 200, 480}) {
      const ParabolicGroundMap map({20.3, 31.7}, 30, bend_per_m, 3000);
      ASSERT_TRUE(map.eye_tracks());
      const EyeTracks& tracks = *map.eye_tracks();
      double most_share = 0;
      for (int i = 0; i < 15000; ++i) {
        const int group = random.integer(0, 4 * wedges_a_side / EyeFront::kGroup - 1);
        const auto wedge = static_cast<std::size_t>(random.integer(0, EyeFront::kGroup - 1));
        const WedgeEdges edges = wedge_edges(group, wedges_a_side, map);
        const GridLine line{random.integer(0, 1), random.uniform(-60, 110)};
        const glm::dvec2 first(edges.x_a[wedge], edges.y_a[wedge]);
        const glm::dvec2 second(edges.x_b[wedge], edges.y_b[wedge]);
        const auto a = cross(tracks, first, line, 2500);
        const auto b = cross(tracks, second, line, 2500);
        const double share = random.uniform(0, 1);
        const auto between =
            cross(tracks, glm::normalize(glm::mix(first, second, share)), line, 2500);
        if (!a || !b || !between || a->piece != b->piece) continue;
        const double margin =
            bends_between_edges(edges, group, wedges_a_side, map, 2500)[a->piece] + 1e-9;
        const double needed = needed_margin(*a, *b, *between, edges.bulge);
        EXPECT_LE(needed, margin) << wedges_a_side << ", " << a->g_m;
        most_share = std::max(most_share, needed / margin);
        ++crossings;
      }
      EXPECT_GT(most_share, 0.05) << bend_per_m << ", " << wedges_a_side;
    }
  EXPECT_GT(crossings, 12000);
}

TEST(WedgeEdges, HaveStraightTracksWithoutBends) {
  const AffineGroundMap map({3, 4}, glm::dmat2(0.03, 0, 0.01, -0.03), {90, 80});
  EXPECT_EQ(bends_between_edges(wedge_edges(0, 40, map), 0, 40, map, 4000), std::vector{0.0});
}

}  // namespace
}  // namespace terrview

#include "terrain/eye_tracks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "tests/support/parabolic_map.h"
#include "tests/support/random_scene.h"

namespace terrview {
namespace {

ParabolicGroundMap some_map() { return {{20.3, 31.7}, 30, 1e-5, 3000}; }

TEST(EyeTracks, KeepWithinTheLimitOfTheMap) {
  const ParabolicGroundMap map = some_map();
  ASSERT_TRUE(map.eye_tracks());
  Random random(1);
  for (int i = 0; i < 20000; ++i) {
    const double azimuth = random.uniform(0, 6.283185);
    const glm::dvec2 direction(std::sin(azimuth), std::cos(azimuth));
    const double g_m = random.uniform(0, 3000);
    const TrackPiece piece = map.eye_tracks()->piece(direction, g_m, 3000);
    EXPECT_LE(piece.begin_m, g_m);
    EXPECT_GT(piece.end_m, g_m);
    EXPECT_LE(glm::distance(piece.at(g_m), map.to_grid(direction * g_m)),
              GroundMap::kTrackError_cells);
    EXPECT_LE(std::max(std::abs(piece.rate.x), std::abs(piece.rate.y)),
              map.eye_tracks()->posts_per_m());
  }
}

TEST(EyeTracks, ChainTheirPieces) {
  const ParabolicGroundMap map = some_map();
  const EyeTracks& tracks = *map.eye_tracks();
  EXPECT_GT(tracks.pieces(), 3);
  for (const glm::dvec2 direction : {glm::dvec2(0, 1), glm::dvec2(-1, 0), glm::dvec2(0.6, -0.8)}) {
    TrackPiece piece = tracks.piece(direction, 0, 3000);
    EXPECT_EQ(piece.start, tracks.eye_uv());
    while (piece.end_m < 3000) {
      const TrackPiece next = tracks.piece(direction, piece.end_m, 3000);
      EXPECT_EQ(next.begin_m, piece.end_m);
      EXPECT_LT(glm::distance(next.start, piece.end), 1e-9);
      piece = next;
    }
  }
}

TEST(EyeTracks, AreCutOffWhereALineEnds) {
  const ParabolicGroundMap map = some_map();
  EXPECT_EQ(map.eye_tracks()->piece({0, 1}, 10, 17).end_m, 17);
}

TEST(EyeTracks, AreNotMadeForMapsThatBendTooOften) {
  const ParabolicGroundMap map({0, 0}, 1, 1, 1e4);
  EXPECT_EQ(map.eye_tracks(), nullptr);
}

}  // namespace
}  // namespace terrview

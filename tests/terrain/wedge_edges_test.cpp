#include "terrain/wedge_edges.h"

#include <gtest/gtest.h>

#include <algorithm>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "terrain/eye_tracks.h"
#include "tests/support/parabolic_map.h"
#include "tests/support/random_scene.h"
#include "tests/support/scenes.h"

namespace terrview {
namespace {

glm::dvec2 place(const GroundMap& map, glm::dvec2 direction, double g_m) {
  return map.eye_tracks()->piece(direction, g_m, map.reach_m()).at(g_m);
}

TEST(WedgeEdges, HaveTracksBetweenThemAsFarFromChordsAsTheySay) {
  Random random(31);
  for (const double bend_per_m : {1e-5, 2e-4})
    for (const int wedges_a_side : {8, 60, 480}) {
      const ParabolicGroundMap map({20.3, 31.7}, 30, bend_per_m, 3000);
      ASSERT_TRUE(map.eye_tracks());
      double furthest = 0;
      double allowed = 0;
      for (int group = 0; group < 4 * wedges_a_side / EyeFront::kGroup; ++group) {
        const WedgeEdges edges = wedge_edges(group, wedges_a_side, map);
        const double bend = bend_between_edges(edges, group, wedges_a_side, map, 2500);
        allowed = std::max(allowed, bend);
        for (int i = 0; i < 400; ++i) {
          const auto wedge = static_cast<std::size_t>(random.integer(0, EyeFront::kGroup - 1));
          const glm::dvec2 a(edges.x_a[wedge], edges.y_a[wedge]);
          const glm::dvec2 b(edges.x_b[wedge], edges.y_b[wedge]);
          const glm::dvec2 direction = glm::normalize(glm::mix(a, b, random.uniform(0, 1)));
          const glm::dvec2 shares = glm::inverse(glm::dmat2(a, b)) * direction;
          const double sum = shares.x + shares.y;
          const double g_m = random.uniform(0, 2500 / sum);
          const glm::dvec2 chord =
              (shares.x * place(map, a, sum * g_m) + shares.y * place(map, b, sum * g_m)) / sum;
          const double off = glm::distance(place(map, direction, g_m), chord);
          EXPECT_LE(off, bend + 1e-9) << wedges_a_side << ", " << g_m;
          furthest = std::max(furthest, off);
        }
      }
      EXPECT_GT(furthest, allowed / 10) << bend_per_m << ", " << wedges_a_side;
    }
}

TEST(WedgeEdges, HaveStraightTracksOnTheirChords) {
  const AffineGroundMap map({3, 4}, glm::dmat2(0.03, 0, 0.01, -0.03), {90, 80});
  EXPECT_EQ(bend_between_edges(wedge_edges(0, 40, map), 0, 40, map, 4000), 0);
}

}  // namespace
}  // namespace terrview

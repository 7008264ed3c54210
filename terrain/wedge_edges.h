// The wedges of azimuth of an EyeFront, a group of them at a time.
#pragma once

#include <array>
#include <vector>

#include "terrain/eye_front.h"
#include "terrain/ground_map.h"

namespace terrview {

// The edges of a group of wedges: lines from the eye, two to each.
struct WedgeEdges {
  using Values = std::array<double, EyeFront::kGroup>;
  // One piece of the tracks of the first edges, or of the second.
  struct alignas(64) Piece {
    alignas(64) Values start_u, start_v, rate_u, rate_v;
  };
  // Unit directions, view frame.
  alignas(64) Values x_a, y_a, x_b, y_b;
  // An arc between two edges stays nearer than the line between them so many times as far away.
  double bulge = 1;
  std::vector<double> begins_m;
  std::vector<Piece> pieces_a;
  std::vector<Piece> pieces_b;
};

// Those of a group of the wedges that `wedges_a_side` make, widened by more than the rounding with
// which a ray finds its wedge.
[[nodiscard]] WedgeEdges wedge_edges(int group, int wedges_a_side, const GroundMap& map);

// In posts: no track between the edges of these wedges is further, up to `to_m`, from where the
// straight lines from one edge's track to the other's are at the same distance. 0 where tracks are
// straight.
[[nodiscard]] double bend_between_edges(const WedgeEdges& edges, int group, int wedges_a_side,
                                        const GroundMap& map, double to_m);

}  // namespace terrview

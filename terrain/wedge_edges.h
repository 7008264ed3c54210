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

// By piece of the tracks, in posts: where a track between the edges of these wedges crosses a line
// of the grid, and what lies between the edges' crossings of it by linear interpolation, where all
// are on that piece, are no further apart. 0 where tracks are straight. Up to `to_m`; pieces that
// begin beyond have what the last before them has.
[[nodiscard]] std::vector<double> bends_between_edges(const WedgeEdges& edges, int group,
                                                      int wedges_a_side, const GroundMap& map,
                                                      double to_m);

}  // namespace terrview

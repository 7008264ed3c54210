// A linear piece of a ray's track over a grid.
#pragma once

#include <cstddef>

#include <glm/vec2.hpp>

#include "terrain/ground_map.h"

namespace terrview {

// uv(g) = start + rate * (g - begin) for g in [begin, end].
struct TrackPiece {
  double begin_m;
  double end_m;
  glm::dvec2 start;
  glm::dvec2 end;
  glm::dvec2 rate;    // posts per metre; 0 where the line runs along a grid line
  glm::dvec2 metres;  // 1 / rate; 0 where rate is 0

  [[nodiscard]] glm::dvec2 at(double g_m) const { return start + rate * (g_m - begin_m); }
};

// Sets `metres` from `rate`. A rate too small to invert crosses no line within any reach: it
// becomes 0.
void set_metres(TrackPiece& piece);

// Puts a piece into place `i` of the arrays of a structure that names its parts alike.
template <class Lanes>
void put_piece(Lanes& lanes, std::size_t i, const TrackPiece& piece) {
  lanes.begin[i] = piece.begin_m;
  lanes.end[i] = piece.end_m;
  lanes.start_u[i] = piece.start.x;
  lanes.start_v[i] = piece.start.y;
  lanes.rate_u[i] = piece.rate.x;
  lanes.rate_v[i] = piece.rate.y;
  lanes.metres_u[i] = piece.metres.x;
  lanes.metres_v[i] = piece.metres.y;
}

// The piece of `line` that begins at `begin_m`, where the grid is at `start`, and ends at `to_m` at
// the latest. On lines from the eye whose map has EyeTracks, the piece that `begin_m` lies on.
[[nodiscard]] TrackPiece track_piece(const GroundMap& map, const GroundLine& line, double begin_m,
                                     glm::dvec2 start, double to_m);

// Where the line from the eye along a unit direction lies over the grid, as rays follow it.
struct TrackPoint {
  glm::dvec2 uv;
  glm::dvec2 rate;  // posts per metre
};
[[nodiscard]] TrackPoint track_point(const GroundMap& map, glm::dvec2 direction, double g_m);

}  // namespace terrview

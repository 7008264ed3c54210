#include "terrain/track_piece.h"

#include <cmath>

namespace terrview {

TrackPiece track_piece(const GroundMap& map, const GroundLine& line, double begin_m,
                       glm::dvec2 start, double to_m) {
  const double end_m = begin_m < to_m ? map.piece_end_m(line, begin_m, to_m) : begin_m;
  TrackPiece piece{begin_m, end_m, start, map.to_grid(line.at(end_m)), {0, 0}, {0, 0}};
  if (!(end_m > begin_m)) return piece;
  // Cheaper, and the vector tracers do the same.
  const glm::dmat2* linear = map.linear();
  const glm::dvec2 linear_rate = linear ? *linear * line.direction : glm::dvec2(0);
  for (int axis = 0; axis < 2; ++axis) {
    const double rate =
        linear ? linear_rate[axis] : (piece.end[axis] - start[axis]) / (end_m - begin_m);
    const double metres = 1 / rate;
    // A rate too small to invert crosses no line within any reach.
    if (!std::isfinite(metres)) continue;
    piece.rate[axis] = rate;
    piece.metres[axis] = metres;
  }
  return piece;
}

}  // namespace terrview

#include "terrain/track_piece.h"

#include <cmath>

#include "terrain/eye_tracks.h"

namespace terrview {

void set_metres(TrackPiece& piece) {
  for (int axis = 0; axis < 2; ++axis) {
    const double metres = 1 / piece.rate[axis];
    const bool is_finite = std::isfinite(metres);
    piece.metres[axis] = is_finite ? metres : 0;
    if (!is_finite) piece.rate[axis] = 0;
  }
}

TrackPiece track_piece(const GroundMap& map, const GroundLine& line, double begin_m,
                       glm::dvec2 start, double to_m) {
  const EyeTracks* tracks = map.eye_tracks();
  if (tracks && line.origin_m == glm::dvec2(0)) return tracks->piece(line.direction, begin_m, to_m);
  const double end_m = begin_m < to_m ? map.piece_end_m(line, begin_m, to_m) : begin_m;
  TrackPiece piece{begin_m, end_m, start, map.to_grid(line.at(end_m)), {0, 0}, {0, 0}};
  if (!(end_m > begin_m)) return piece;
  // Cheaper where it is known, and the vector tracers do the same.
  const glm::dmat2* linear = map.linear();
  piece.rate = linear ? *linear * line.direction : (piece.end - start) / (end_m - begin_m);
  set_metres(piece);
  return piece;
}

TrackPoint track_point(const GroundMap& map, glm::dvec2 direction, double g_m) {
  if (const EyeTracks* tracks = map.eye_tracks()) {
    const TrackPiece piece = tracks->piece(direction, g_m, g_m);
    return {piece.at(g_m), piece.rate};
  }
  return {map.to_grid(direction * g_m), map.jacobian(direction * g_m) * direction};
}

}  // namespace terrview

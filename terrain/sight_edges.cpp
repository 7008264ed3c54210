#include "terrain/sight_edges.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "terrain/eye_tracks.h"
#include "terrain/track_piece.h"

namespace terrview {
namespace {

// An edge steeper than this, or one that turns by more from piece to piece, is not followed.
constexpr double kSteepest = 1.25;
constexpr double kSharpest = 4 * SightEdges::kTurn;

// The piece on which a distance lies, and where it ends.
TrackPiece piece_from(const GroundMap& map, glm::dvec2 direction, double from_m) {
  constexpr double kEndless_m = 1e12;
  if (const EyeTracks* tracks = map.eye_tracks()) {
    TrackPiece piece = tracks->piece(direction, from_m, kEndless_m);
    if (tracks->piece_at(from_m) == tracks->pieces() - 1) piece.end_m = kEndless_m;
    return piece;
  }
  return track_piece(map, {{0, 0}, direction}, 0, map.to_grid({0, 0}), kEndless_m);
}

}  // namespace

SightSide::SightSide(const Terrain& terrain, int side)
    : axis(side / 2), forward(side % 2 == 0 ? 1 : -1) {
  const TerrainLayer& layer = terrain.layers()[0];
  eye = layer.map->to_grid({0, 0});
  base = static_cast<int>(std::floor(eye[1 - axis]));
  lines = axis == 0 ? layer.grid->columns : layer.grid->rows;
  rows = axis == 0 ? layer.grid->rows : layer.grid->columns;
}

int SightSide::first_line() const {
  return forward > 0 ? static_cast<int>(std::floor(eye[axis])) + 1
                     : static_cast<int>(std::ceil(eye[axis])) - 1;
}

SightEdges::SightEdges(const Terrain& terrain, const SightSide& side, int wedges, int first,
                       int count, double from_ahead)
    : map_(terrain.layers()[0].map.get()), side_(side) {
  const glm::dmat2 to_ground = glm::inverse(map_->jacobian({0, 0}));
  const VerticalFrame& frame = terrain.frame();
  const auto size = static_cast<std::size_t>(count);
  for (int i = 0; i < count; ++i) {
    glm::dvec2 in_grid;
    in_grid[side.axis] = side.forward;
    in_grid[1 - side.axis] = -1 + 2.0 * (first + i) / wedges;
    const glm::dvec2 direction = glm::normalize(to_ground * in_grid);
    directions_.push_back(direction);
    curvature.push_back(
        static_cast<float>(direction.x * direction.x * frame.east_curvature_per_m +
                           direction.y * direction.y * frame.north_curvature_per_m));
  }
  const std::size_t padded = (size + 2 * kVector - 1) / kVector * kVector;
  curvature.resize(padded, curvature.back());
  for (std::vector<float>* values : {&across, &slope, &inverse_slope, &metres, &metres_per_post})
    values->resize(padded);
  piece_end_.assign(size, -1);
  piece_end_m_.assign(size, 0);
  static_cast<void>(advance(from_ahead));
}

bool SightEdges::advance(double to_ahead) {
  if (to_ahead <= next_end_) return true;
  double next_end = std::numeric_limits<double>::infinity();
  is_steep_ = false;
  const std::size_t size = directions_.size();
  for (std::size_t i = 0; i < size; ++i) {
    if (piece_end_[i] < to_ahead && !load(i, to_ahead)) return false;
    next_end = std::min(next_end, piece_end_[i]);
    is_steep_ = is_steep_ || std::abs(slope[i]) > 1;
  }
  for (std::vector<float>* values : {&across, &slope, &inverse_slope, &metres, &metres_per_post})
    std::fill(values->begin() + static_cast<std::ptrdiff_t>(size), values->end(),
              (*values)[size - 1]);
  next_end_ = next_end;
  return true;
}

// The piece that an edge is on so far ahead.
bool SightEdges::load(std::size_t edge, double to_ahead) {
  constexpr double kFlattest = 1e-6;  // slopes, that each has an inverse
  const int axis = side_.axis;
  while (piece_end_[edge] < to_ahead) {
    const TrackPiece piece = piece_from(*map_, directions_[edge], piece_end_m_[edge]);
    const double rate = side_.forward * piece.rate[axis];
    const double rise = piece.rate[1 - axis] / rate;
    if (!(rate > 0) || !(std::abs(rise) <= kSteepest)) return false;
    if (piece_end_m_[edge] > 0 && std::abs(rise - slope[edge]) > kSharpest) return false;
    const double begin = side_.forward * (piece.start[axis] - side_.eye[axis]);
    piece_end_m_[edge] = piece.end_m;
    piece_end_[edge] = begin + rate * (piece.end_m - piece.begin_m);
    const double sloped = std::abs(rise) < kFlattest ? std::copysign(kFlattest, rise) : rise;
    across[edge] = static_cast<float>(piece.start[1 - axis] - side_.base - rise * begin);
    slope[edge] = static_cast<float>(sloped);
    inverse_slope[edge] = static_cast<float>(1 / sloped);
    metres[edge] = static_cast<float>(piece.begin_m - begin / rate);
    metres_per_post[edge] = static_cast<float>(1 / rate);
  }
  return true;
}

}  // namespace terrview

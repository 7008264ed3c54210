#include "ingest/curved_ground_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "ingest/patch_vectors.h"

namespace terrview {
namespace {

// The least piece, as a share of the disc's radius: far below any cell, above rounding.
constexpr double kLeastPiece = 1e-10;
// A line that begins this near (metres) to the eye is the eye's.
constexpr double kAtTheEye_m = 1e-9;

// Where a line crosses the circle; both ends are NaN if it does not.
struct Chord {
  double in_m;
  double out_m;
};

Chord chord_of(const GroundDisc& disc, const GroundLine& line) {
  const glm::dvec2 from_centre = line.origin_m - disc.centre_m;
  const double along = glm::dot(from_centre, line.direction);
  const double across = from_centre.x * line.direction.y - from_centre.y * line.direction.x;
  const double half = std::sqrt(disc.radius_m * disc.radius_m - across * across);
  return {-along - half, -along + half};
}

// How far along the line a square ends.
double leaves_square_m(const GroundSquare& square, const GroundLine& line) {
  double out_m = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 2; ++axis) {
    const double speed = line.direction[axis];
    if (speed == 0) continue;
    const double side = square.centre_m[axis] + (speed > 0 ? square.half_m : -square.half_m);
    out_m = std::min(out_m, (side - line.origin_m[axis]) / speed);
  }
  return out_m;
}

double off_grid(glm::dvec2 uv, glm::dvec2 last_post) {
  return glm::length(glm::max(glm::dvec2(0), glm::max(uv - last_post, -uv)));
}

// The bounds that a piece has met so far, and how far they let it go.
class PieceLimit {
 public:
  PieceLimit(const GroundLine& line, double from_m)
      : from_m_(from_m),
        from_eye_(glm::dot(line.origin_m, line.origin_m) < kAtTheEye_m * kAtTheEye_m) {}

  void meet(const PatchTree::Leaf& leaf, glm::dvec2 direction, double allowed_cells) {
    const glm::dvec2 bend = leaf.patch.bend(direction);
    const double off_grid = GroundMap::kDistantTrackError * leaf.grid_distance_cells;
    allowed_cells += off_grid;
    per_m2_ = std::max(per_m2_, glm::length(bend) / allowed_cells);
    if (off_grid == 0) metres_per_m2_ = std::max(metres_per_m2_, leaf.patch.metres(bend));
  }

  // A chord of length L strays from its curve by at most bend L^2 / 8, and by bend (g - g0) (g1 -
  // g) / 2 at g, which over g is largest at sqrt(g0 g1).
  [[nodiscard]] double end_m() const {
    const double by_cells = from_m_ + std::sqrt(8 / per_m2_);
    if (!from_eye_ || metres_per_m2_ == 0) return by_cells;
    const double step = std::sqrt(2 * 0.9 * GroundMap::kTrackError_rad / metres_per_m2_);
    const double root = std::sqrt(from_m_) + step;
    return std::min(by_cells, root * root);
  }

 private:
  double from_m_;
  bool from_eye_;
  double per_m2_ = 0;
  double metres_per_m2_ = 0;
};

}  // namespace

CurvedGroundMap::CurvedGroundMap(const ExactGroundMap& exact, glm::ivec2 grid_size,
                                 const GroundDisc& disc, double reach_m)
    : last_post_(grid_size - 1),
      disc_(disc),
      reach_m_(reach_m),
      patches_(exact, grid_size, {disc.centre_m, disc.radius_m}, disc.radius_m),
      centre_uv_(patches_.leaf_at(disc.centre_m).patch.at(disc.centre_m)),
      piece_error_cells_(0.9 * kTrackError_cells - 4 * patches_.error_cells()) {
  if (glm::length(disc.centre_m) < disc.radius_m) tracks_ = EyeTracks::make(*this);
}

glm::dvec2 CurvedGroundMap::to_grid(glm::dvec2 ground_m) const {
  const glm::dvec2 from_centre = ground_m - disc_.centre_m;
  const double away2 = glm::dot(from_centre, from_centre);
  if (away2 <= disc_.radius_m * disc_.radius_m)
    return patches_.leaf_at(ground_m).patch.at(ground_m);
  const double share = std::sqrt(away2) / disc_.radius_m;
  const glm::dvec2 on_circle = disc_.centre_m + from_centre / share;
  return centre_uv_ + share * (patches_.leaf_at(on_circle).patch.at(on_circle) - centre_uv_);
}

glm::dmat2 CurvedGroundMap::jacobian(glm::dvec2 ground_m) const {
  const glm::dvec2 point = disc_.nearest(ground_m);
  return patches_.leaf_at(point).patch.jacobian(point);
}

void CurvedGroundMap::places(const GroundPoints& points, const Places& found) const {
  patch_places(patches_, disc_, centre_uv_, points, found);
}

void CurvedGroundMap::jacobians(const GroundPoints& points, const Jacobians& found) const {
  patch_jacobians(patches_, disc_, points, found);
}

double CurvedGroundMap::reach_m(glm::dvec2 direction) const {
  return std::min(reach_m_, std::max(0.0, chord_of(disc_, {{0, 0}, direction}).out_m));
}

double CurvedGroundMap::piece_end_m(const GroundLine& line, double from_m, double limit_m) const {
  const Chord chord = chord_of(disc_, line);
  const double least_m = kLeastPiece * disc_.radius_m;
  // Also false where the line misses the disc and the chord is NaN.
  const bool inside = from_m >= chord.in_m - least_m && from_m < chord.out_m - least_m;
  double end_m = 0;
  if (inside)
    end_m = end_inside(line, from_m, std::min(limit_m, chord.out_m));
  else
    end_m =
        end_outside(line, from_m, chord.in_m > from_m ? std::min(limit_m, chord.in_m) : limit_m);
  return std::min(limit_m, std::max(end_m, from_m + least_m));
}

void CurvedGroundMap::piece_ends_m(const GroundLines& lines, const Stretches& stretches,
                                   std::span<double> ends_m) const {
  const PieceRules rules{piece_error_cells_, kLeastPiece * disc_.radius_m, kAtTheEye_m};
  patch_piece_ends(patches_, disc_, rules, lines, stretches, ends_m);
  for (std::size_t i = 0; i < ends_m.size(); ++i)
    if (std::isnan(ends_m[i]))
      ends_m[i] = piece_end_m({{lines.x0_m[i], lines.y0_m[i]}, {lines.x[i], lines.y[i]}},
                              stretches.from_m[i], stretches.limit_m[i]);
}

double CurvedGroundMap::end_inside(const GroundLine& line, double from_m, double limit_m) const {
  PieceLimit limit(line, from_m);
  double at_m = from_m;
  const double nudge_m = kLeastPiece * disc_.radius_m;
  while (true) {
    const PatchTree::Leaf& leaf = patches_.leaf_at(line.at(at_m + nudge_m));
    limit.meet(leaf, line.direction, piece_error_cells_);
    const double out_m = std::max(at_m + nudge_m, leaves_square_m(leaf.patch.square(), line));
    const double end_m = limit.end_m();
    if (end_m <= out_m || out_m >= limit_m) return std::clamp(end_m, at_m, limit_m);
    at_m = out_m;
  }
}

double CurvedGroundMap::distance_from_grid(const GroundLine& line, double from_m,
                                           double to_m) const {
  const glm::dvec2 start = to_grid(line.at(from_m));
  const glm::dvec2 end = to_grid(line.at(to_m));
  const double nearest =
      (off_grid(start, last_post_) + off_grid(end, last_post_) - 1.1 * glm::distance(start, end)) /
      2;
  return std::max(0.0, nearest);
}

// Half the step until three points of the chord are near enough to the curve. No posts lie here.
double CurvedGroundMap::end_outside(const GroundLine& line, double from_m, double limit_m) const {
  constexpr int kHalvings = 40;
  double end_m = limit_m;
  for (int i = 0; i < kHalvings && chord_excess(line, from_m, end_m) > 0; ++i)
    end_m = from_m + (end_m - from_m) / 2;
  return end_m;
}

double CurvedGroundMap::chord_excess(const GroundLine& line, double from_m, double to_m) const {
  const glm::dvec2 start = to_grid(line.at(from_m));
  const glm::dvec2 end = to_grid(line.at(to_m));
  double excess = 0;
  for (const double share : {0.25, 0.5, 0.75}) {
    const glm::dvec2 on_chord = glm::mix(start, end, share);
    const glm::dvec2 on_curve = to_grid(line.at(glm::mix(from_m, to_m, share)));
    const double allowed = kTrackError_cells + kDistantTrackError * off_grid(on_curve, last_post_);
    excess = std::max(excess, glm::distance(on_chord, on_curve) - allowed);
  }
  return excess;
}

}  // namespace terrview

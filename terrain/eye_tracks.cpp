#include "terrain/eye_tracks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "terrain/square_sectors.h"

namespace terrview {
namespace {

constexpr int kFewestSectors = 64;  // a side
constexpr int kMostSectors = 1024;
constexpr std::size_t kMostKnots = 96;

// What the table may add to the errors of a map, as a share of its limits.
constexpr double kShareOfLimit = 0.1;

}  // namespace

std::optional<EyeTracks> EyeTracks::make(const GroundMap& map) {
  for (int sectors = kFewestSectors; sectors <= kMostSectors; sectors *= 2) {
    EyeTracks tracks(map, sectors);
    if (!tracks.find_knots(map)) return std::nullopt;
    tracks.fill(map);
    if (!tracks.is_close_to(map)) continue;
    tracks.carry_back();
    return tracks;
  }
  return std::nullopt;
}

EyeTracks::EyeTracks(const GroundMap& map, int sectors_a_side)
    : sectors_a_side_(sectors_a_side), eye_uv_(map.to_grid({0, 0})) {}

// The next knot is where the first of the table's directions needs one.
bool EyeTracks::find_knots(const GroundMap& map) {
  const double reach_m = map.reach_m();
  knots_m_.assign(1, 0);
  while (knots_m_.back() < reach_m) {
    if (knots_m_.size() > kMostKnots) return false;
    double next_m = reach_m;
    for (int i = 0; i < 4 * sectors_a_side_; ++i) {
      const GroundLine line{{0, 0}, edge(i, 0)};
      const double last_m = map.reach_m(line.direction);
      if (knots_m_.back() >= last_m) continue;
      const double end_m = map.piece_end_m(line, knots_m_.back(), std::min(next_m, last_m));
      if (end_m < last_m) next_m = std::min(next_m, end_m);
    }
    if (!(next_m > knots_m_.back())) return false;
    knots_m_.push_back(next_m);
  }
  return true;
}

void EyeTracks::fill(const GroundMap& map) {
  const int sectors = 4 * sectors_a_side_;
  const auto count = static_cast<std::size_t>(pieces());
  coefficients_.reserve(static_cast<std::size_t>(sectors) * count * kCoefficients);
  for (int sector = 0; sector < sectors; ++sector) {
    const glm::dvec2 a = edge(sector, 0);
    const glm::dvec2 b = edge(sector, 1);
    const glm::dmat2 per_direction = glm::inverse(glm::dmat2(a, b));
    const std::vector<glm::dvec2> knots_a = knots_along(map, a);
    const std::vector<glm::dvec2> knots_b = knots_along(map, b);
    glm::dmat2 start(0);
    for (std::size_t i = 0; i < count; ++i) {
      const glm::dmat2 end = glm::dmat2(knots_a[i + 1], knots_b[i + 1]) * per_direction;
      const glm::dmat2 rate = (end - start) / (knots_m_[i + 1] - knots_m_[i]);
      for (const glm::dmat2& m : {start, rate})
        coefficients_.insert(coefficients_.end(), {m[0].x, m[1].x, m[0].y, m[1].y});
      start = end;
    }
  }
}

void EyeTracks::carry_back() {
  const auto count = static_cast<std::size_t>(pieces());
  lines_.reserve(coefficients_.size());
  for (std::size_t i = 0; i < coefficients_.size() / kCoefficients; ++i) {
    const double* c = coefficients_.data() + i * kCoefficients;
    const double begin_m = knots_m_[i % count];
    for (const int j : {0, 1, 2, 3})
      lines_.push_back(static_cast<float>(c[j] - c[j + 4] * begin_m));
    for (const int j : {4, 5, 6, 7}) lines_.push_back(static_cast<float>(c[j]));
    posts_per_m_ =
        std::max({posts_per_m_, std::abs(c[4]) + std::abs(c[5]), std::abs(c[6]) + std::abs(c[7])});
  }
  near_knots_m_.assign(knots_m_.begin(), knots_m_.end());
}

// From the eye, in posts. Beyond the last post the last piece goes on.
std::vector<glm::dvec2> EyeTracks::knots_along(const GroundMap& map, glm::dvec2 direction) const {
  const double last_m = map.reach_m(direction);
  std::vector<glm::dvec2> knots{{0, 0}};
  glm::dvec2 rate(0);
  for (std::size_t i = 1; i < knots_m_.size(); ++i) {
    const double begin_m = knots_m_[i - 1];
    const double end_m = std::min(knots_m_[i], last_m);
    if (begin_m < last_m)
      rate = (map.to_grid(direction * end_m) - eye_uv_ - knots.back()) / (end_m - begin_m);
    knots.push_back(knots.back() + rate * (knots_m_[i] - begin_m));
  }
  return knots;
}

// Amid the sectors, where the table is worst.
bool EyeTracks::is_close_to(const GroundMap& map) const {
  for (int sector = 0; sector < 4 * sectors_a_side_; ++sector) {
    const glm::dvec2 direction = edge(sector, 0.5);
    const double last_m = map.reach_m(direction);
    for (std::size_t i = 1; i < knots_m_.size() && knots_m_[i] <= last_m; ++i) {
      const double g_m = knots_m_[i];
      const glm::dvec2 exact = map.to_grid(direction * g_m);
      const double error = glm::distance(piece(direction, knots_m_[i - 1], g_m).end, exact);
      const double cells_per_rad = glm::length(exact - eye_uv_);
      const double limit =
          kShareOfLimit * std::min(GroundMap::kTrackError_cells,
                                   GroundMap::kTrackError_rad * std::max(1.0, cells_per_rad));
      if (!(error <= limit) &&
          !(error <= GroundMap::kDistantTrackError * distance_from_grid(map, sector, i)))
        return false;
    }
  }
  return true;
}

double EyeTracks::distance_from_grid(const GroundMap& map, int sector, std::size_t knot) const {
  const double from_m = knots_m_[knot - 1];
  const double to_m = knots_m_[std::min(knot + 1, knots_m_.size() - 1)];
  const auto end = [&](double share) { return map.to_grid(edge(sector, share) * to_m); };
  // Tracks between two of these are no further than half of this from one of them.
  const double gap =
      1.1 * std::max(glm::distance(end(0), end(0.5)), glm::distance(end(0.5), end(1)));
  double least = std::numeric_limits<double>::infinity();
  for (const double share : {0.0, 0.5, 1.0})
    least = std::min(least, map.distance_from_grid({{0, 0}, edge(sector, share)}, from_m, to_m));
  return least - gap / 2;
}

glm::dvec2 EyeTracks::edge(int sector, double share) const {
  return sector_edge(sector / sectors_a_side_, sector % sectors_a_side_ + share, sectors_a_side_);
}

int EyeTracks::piece_at(double from_m) const {
  const auto beyond = std::upper_bound(knots_m_.begin() + 1, knots_m_.end() - 1, from_m);
  return static_cast<int>(beyond - knots_m_.begin()) - 1;
}

EyeTracks::Start EyeTracks::start(int sector, int piece, glm::dvec2 direction) const {
  const auto row = static_cast<std::size_t>(sector) * static_cast<std::size_t>(pieces()) +
                   static_cast<std::size_t>(piece);
  const double* c = coefficients_.data() + row * kCoefficients;
  return {eye_uv_ + glm::dvec2(c[0] * direction.x + c[1] * direction.y,
                               c[2] * direction.x + c[3] * direction.y),
          {c[4] * direction.x + c[5] * direction.y, c[6] * direction.x + c[7] * direction.y}};
}

TrackPiece EyeTracks::piece(glm::dvec2 direction, double from_m, double to_m) const {
  const int i = piece_at(from_m);
  const auto at = static_cast<std::size_t>(i);
  const Start begin = start(sector_of(direction, sectors_a_side_), i, direction);
  TrackPiece piece{knots_m_[at], std::max(from_m, std::min(knots_m_[at + 1], to_m)),
                   begin.uv,     {},
                   begin.rate,   {0, 0}};
  set_metres(piece);
  piece.end = piece.at(piece.end_m);
  return piece;
}

}  // namespace terrview

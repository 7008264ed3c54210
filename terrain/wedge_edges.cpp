#include "terrain/wedge_edges.h"

#include <algorithm>
#include <cstddef>

#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>

#include "terrain/eye_tracks.h"
#include "terrain/square_sectors.h"

namespace terrview {

namespace {

// Wider than the rounding with which a ray finds its wedge.
constexpr double kEdgeMargin = 1e-12;

// The tracks of one edge, as those of each wedge's.
void set_pieces(std::vector<WedgeEdges::Piece>& pieces, std::size_t wedge, glm::dvec2 direction,
                const GroundMap& map, glm::dvec2 eye_uv) {
  const auto set = [wedge](WedgeEdges::Piece& piece, glm::dvec2 start, glm::dvec2 rate) {
    piece.start_u[wedge] = start.x;
    piece.start_v[wedge] = start.y;
    piece.rate_u[wedge] = rate.x;
    piece.rate_v[wedge] = rate.y;
  };
  if (const glm::dmat2* jacobian = map.linear()) {
    set(pieces[0], eye_uv, *jacobian * direction);
    return;
  }
  const EyeTracks& tracks = *map.eye_tracks();
  const int sector = sector_of(direction, tracks.sectors_a_side());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const EyeTracks::Start start = tracks.start(sector, static_cast<int>(i), direction);
    set(pieces[i], start.uv, start.rate);
  }
}

// What lies between the tracks of wedges' edges, in posts.
class TrackChords {
 public:
  TrackChords(const WedgeEdges& edges, const EyeTracks& tracks) : edges_(edges), tracks_(tracks) {}

  // How far off the chords of a piece, `past_m` on it, the table has tracks of the directions that
  // part its sectors.
  [[nodiscard]] double bend(std::size_t i, int wedge, int wedges_a_side, std::size_t piece,
                            double past_m) const {
    const int sectors = tracks_.sectors_a_side();
    const int side = wedge / wedges_a_side;
    const double first = static_cast<double>(wedge % wedges_a_side) * sectors / wedges_a_side;
    const double end = first + static_cast<double>(sectors) / wedges_a_side;
    double most = 0;
    for (int k = static_cast<int>(first) + 1; k < end; ++k) {
      const glm::dvec2 direction = sector_edge(side, k, sectors);
      const glm::dmat2 edges(edges_.x_a[i], edges_.y_a[i], edges_.x_b[i], edges_.y_b[i]);
      const glm::dvec2 shares = glm::inverse(edges) * direction;
      const EyeTracks::Start start =
          tracks_.start(side * sectors + k, static_cast<int>(piece), direction);
      const glm::dvec2 chord = shares.x * from_eye(edges_.pieces_a[piece], i, past_m) +
                               shares.y * from_eye(edges_.pieces_b[piece], i, past_m);
      const glm::dvec2 track = start.uv + start.rate * past_m - tracks_.eye_uv();
      most = std::max(most, glm::distance(track, chord));
    }
    return most;
  }

  // Where pieces of the two edges, carried back to the eye, miss it: how far apart, and by how
  // much.
  struct Misses {
    double apart, most;
  };
  [[nodiscard]] Misses misses(std::size_t i, std::size_t piece) const {
    const double back_m = -edges_.begins_m[piece];
    const glm::dvec2 a = from_eye(edges_.pieces_a[piece], i, back_m);
    const glm::dvec2 b = from_eye(edges_.pieces_b[piece], i, back_m);
    return {glm::distance(a, b), std::max(glm::length(a), glm::length(b))};
  }

 private:
  [[nodiscard]] glm::dvec2 from_eye(const WedgeEdges::Piece& piece, std::size_t i,
                                    double past_m) const {
    const glm::dvec2 start(piece.start_u[i], piece.start_v[i]);
    const glm::dvec2 rate(piece.rate_u[i], piece.rate_v[i]);
    return start + rate * past_m - tracks_.eye_uv();
  }

  const WedgeEdges& edges_;
  const EyeTracks& tracks_;
};

}  // namespace

WedgeEdges wedge_edges(int group, int wedges_a_side, const GroundMap& map) {
  WedgeEdges edges;
  const EyeTracks* tracks = map.eye_tracks();
  const glm::dvec2 eye_uv = map.to_grid({0, 0});
  edges.begins_m = tracks ? tracks->knots_m() : std::vector<double>{0, map.reach_m()};
  edges.begins_m.pop_back();
  edges.pieces_a.resize(edges.begins_m.size());
  edges.pieces_b.resize(edges.begins_m.size());
  for (int i = 0; i < EyeFront::kGroup; ++i) {
    const int wedge = group * EyeFront::kGroup + i;
    const int side = wedge / wedges_a_side;
    const double first = wedge % wedges_a_side;
    const glm::dvec2 a = sector_edge(side, first - kEdgeMargin * wedges_a_side, wedges_a_side);
    const glm::dvec2 b = sector_edge(side, first + 1 + kEdgeMargin * wedges_a_side, wedges_a_side);
    const auto j = static_cast<std::size_t>(i);
    edges.x_a[j] = a.x;
    edges.y_a[j] = a.y;
    edges.x_b[j] = b.x;
    edges.y_b[j] = b.y;
    edges.bulge = std::max(edges.bulge, 2 / glm::length(a + b));
    set_pieces(edges.pieces_a, j, a, map, eye_uv);
    set_pieces(edges.pieces_b, j, b, map, eye_uv);
  }
  return edges;
}

// Were the lines of a piece all to come from one point, what they cross a line of the grid at would
// be linear from edge to edge. But
//
// - carried back, the edges' miss each other: all are nearer to lines from the middle between them
//   than half of that, at both ends and between, and interpolation goes a quarter beyond the edges;
// - the table's tracks are linear in the direction within a sector, so they leave the chords from
//   edge to edge most where two sectors meet, at an end of the piece;
// - directions are of unit length, up to `bulge` times that of the chord: that is another place on
//   the chord's track, but for what its piece, or the next one, misses the eye by.
std::vector<double> bends_between_edges(const WedgeEdges& edges, int group, int wedges_a_side,
                                        const GroundMap& map, double to_m) {
  const std::size_t pieces = edges.begins_m.size();
  std::vector<double> bends(pieces, 0.0);
  if (!map.eye_tracks()) return bends;
  const TrackChords chords(edges, *map.eye_tracks());
  for (std::size_t piece = 0; piece < pieces; ++piece) {
    const double begin_m = edges.begins_m[piece];
    if (piece > 0 && begin_m >= to_m) {
      bends[piece] = bends[piece - 1];
      continue;
    }
    const std::size_t next = std::min(piece + 1, pieces - 1);
    const double end_m = next > piece ? edges.begins_m[next] : std::max(to_m, begin_m);
    for (std::size_t i = 0; i < EyeFront::kGroup; ++i) {
      const int wedge = group * EyeFront::kGroup + static_cast<int>(i);
      const double bend = std::max(chords.bend(i, wedge, wedges_a_side, piece, 0),
                                   chords.bend(i, wedge, wedges_a_side, piece, end_m - begin_m));
      const auto [apart, most] = chords.misses(i, piece);
      const double miss = std::max(most, chords.misses(i, next).most);
      bends[piece] = std::max(bends[piece], bend + 1.5 * apart + 3 * (edges.bulge - 1) * miss);
    }
  }
  return bends;
}

}  // namespace terrview

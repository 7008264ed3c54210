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

// What lies between the tracks of a wedge's edges, up to a distance, in posts.
class TrackChords {
 public:
  TrackChords(const WedgeEdges& edges, const EyeTracks& tracks, double to_m)
      : edges_(edges), tracks_(tracks), to_m_(to_m) {}

  // How far off the chords the table has tracks of the directions that part its sectors.
  [[nodiscard]] double bend(std::size_t i, int wedge, int wedges_a_side) const {
    const int sectors = tracks_.sectors_a_side();
    const int side = wedge / wedges_a_side;
    const double first = static_cast<double>(wedge % wedges_a_side) * sectors / wedges_a_side;
    const double end = first + static_cast<double>(sectors) / wedges_a_side;
    const glm::dmat2 to_shares =
        glm::inverse(glm::dmat2(edges_.x_a[i], edges_.y_a[i], edges_.x_b[i], edges_.y_b[i]));
    double most = 0;
    for (int k = static_cast<int>(first) + 1; k < end; ++k) {
      const glm::dvec2 direction = sector_edge(side, k, sectors);
      const glm::dvec2 shares = to_shares * direction;
      visit_knots([&](std::size_t piece, double past_m) {
        const EyeTracks::Start start =
            tracks_.start(side * sectors + k, static_cast<int>(piece), direction);
        const glm::dvec2 chord = shares.x * from_eye(edges_.pieces_a[piece], i, past_m) +
                                 shares.y * from_eye(edges_.pieces_b[piece], i, past_m);
        const glm::dvec2 track = start.uv + start.rate * past_m - tracks_.eye_uv();
        most = std::max(most, glm::distance(track, chord));
      });
    }
    return most;
  }

  // How far from the eye pieces of the edges' tracks come, carried back to it.
  [[nodiscard]] double miss(std::size_t i) const {
    double most = 0;
    visit_knots([&](std::size_t piece, double) {
      for (const auto* pieces : {&edges_.pieces_a, &edges_.pieces_b})
        most = std::max(most, glm::length(from_eye((*pieces)[piece], i, -edges_.begins_m[piece])));
    });
    return most;
  }

 private:
  // Up to the last knot before to_m_, and there.
  template <class Visit>
  void visit_knots(const Visit& visit) const {
    std::size_t piece = 0;
    for (; piece + 1 < edges_.begins_m.size() && edges_.begins_m[piece + 1] < to_m_; ++piece)
      visit(piece, 0.0);
    visit(piece, 0.0);
    visit(piece, to_m_ - edges_.begins_m[piece]);
  }

  [[nodiscard]] glm::dvec2 from_eye(const WedgeEdges::Piece& piece, std::size_t i,
                                    double past_m) const {
    const glm::dvec2 start(piece.start_u[i], piece.start_v[i]);
    const glm::dvec2 rate(piece.rate_u[i], piece.rate_v[i]);
    return start + rate * past_m - tracks_.eye_uv();
  }

  const WedgeEdges& edges_;
  const EyeTracks& tracks_;
  double to_m_;
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

// Within a sector of the table tracks are linear in the direction's x and y, and in the distance
// between knots: so they leave chords most where two sectors meet, at a knot. The direction there,
// of unit length, is up to `bulge` times that of the chord: that is another place on its track, but
// for what its piece, and the next one, miss the eye by.
double bend_between_edges(const WedgeEdges& edges, int group, int wedges_a_side,
                          const GroundMap& map, double to_m) {
  if (!map.eye_tracks()) return 0;
  const TrackChords chords(edges, *map.eye_tracks(), to_m);
  double bend = 0;
  double miss = 0;
  for (std::size_t i = 0; i < EyeFront::kGroup; ++i) {
    bend = std::max(bend,
                    chords.bend(i, group * EyeFront::kGroup + static_cast<int>(i), wedges_a_side));
    miss = std::max(miss, chords.miss(i));
  }
  return bend + 3 * (edges.bulge - 1) * miss;
}

}  // namespace terrview

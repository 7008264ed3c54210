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

}  // namespace terrview

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "terrain/sector_bounds.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for every instruction set
//
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "terrain/eye_tracks.h"
#include "terrain/sector_bounds.h"
#include "terrain/square_sectors.h"
#include "terrain/vec_inline.h"
#include "terrain/vector_ground-inl.h"

HWY_BEFORE_NAMESPACE();
namespace terrview {
namespace HWY_NAMESPACE {

// Larger than the rounding of a clearance, as a share of the numbers it comes from.
constexpr double kBoundRounding = 1e-11;

class SectorBounds {
 public:
  SectorBounds(const Terrain& terrain, const WedgeEdges& edges, double margin_cells)
      : frame_(terrain.frame()),
        posts_(*terrain.layers()[0].grid),
        flat_(terrain.frame().north_curvature_per_m == 0 &&
              terrain.frame().east_curvature_per_m == 0),
        margin_cells_(margin_cells),
        last_cell_(terrain.layers()[0].grid->columns - 2, terrain.layers()[0].grid->rows - 2),
        eye_height_m_(terrain.frame().eye_height_m),
        z_scale_(terrain.frame().z_scale),
        edges_(edges) {}

  // The bounds of the sectors of lanes `first`, ... of the group.
  VEC_INLINE V at(const SectorRing& ring, std::size_t first) const {
    M outside;
    M wide;
    const V height = highest(ring, first, outside, wide);
    const V z = ceiling(ring, first, height);
    const V slack = of(kBoundRounding) *
                    (hn::Abs(of(z_scale_) * height) + of(std::abs(eye_height_m_)) + hn::Abs(z));
    const V top = z + slack;
    const V near = ring.near_m > 0 ? top / of(ring.near_m) : hn::Inf(D());
    const V bound = hn::IfThenElse(top < of(0), top / of(ring.far_m), near);
    // Above the rounding to a float.
    const V rounded_up = bound + hn::Abs(bound) * of(0x1p-22) + of(1e-30);
    const M empty = hn::Or(outside, height == of(-std::numeric_limits<double>::infinity()));
    const V known = hn::IfThenElse(wide, hn::Inf(D()), rounded_up);
    return hn::IfThenElse(empty, of(-std::numeric_limits<double>::infinity()), known);
  }

 private:
  // The first and last block along an axis.
  struct Blocks {
    V first, last;
  };

  // Those between the least and the greatest coordinate of a sector's corners.
  VEC_INLINE Blocks blocks(int level, const std::array<V, 4>& corners, double last_cell, M& outside,
                           M& wide) const {
    const V low = hn::Min(hn::Min(corners[0], corners[1]), hn::Min(corners[2], corners[3])) -
                  of(margin_cells_);
    const V high = hn::Max(hn::Max(corners[0], corners[1]), hn::Max(corners[2], corners[3])) +
                   of(margin_cells_);
    outside = hn::Or(high<of(0), low> of(last_cell + 1));
    const V per_block = of(std::ldexp(1.0, -level));
    const auto block = [&](V at) HWY_ATTR {
      return hn::Floor(hn::Floor(hn::Min(hn::Max(at, of(0)), of(last_cell))) * per_block);
    };
    const Blocks found{block(low), block(high)};
    wide = found.last > found.first + of(1);
    return found;
  }

  // Along one axis, where the edges cross the ends of a ring.
  using PieceValues = WedgeEdges::Values WedgeEdges::Piece::*;
  VEC_INLINE std::array<V, 4> corners(const SectorRing& ring, std::size_t first, PieceValues start,
                                      PieceValues rate) const {
    const auto at = [&](const std::vector<WedgeEdges::Piece>& pieces, std::size_t piece,
                        double distance_m) HWY_ATTR {
      return hn::Load(D(), (pieces[piece].*start).data() + first) +
             hn::Load(D(), (pieces[piece].*rate).data() + first) *
                 of(distance_m - edges_.begins_m[piece]);
    };
    const double far_m = ring.far_m * edges_.bulge;
    return {at(edges_.pieces_a, ring.near_piece, ring.near_m),
            at(edges_.pieces_a, ring.far_piece, far_m),
            at(edges_.pieces_b, ring.near_piece, ring.near_m),
            at(edges_.pieces_b, ring.far_piece, far_m)};
  }

  VEC_INLINE V highest(const SectorRing& ring, std::size_t first, M& outside, M& wide) const {
    using Piece = WedgeEdges::Piece;
    M outside_u;
    M outside_v;
    M wide_u;
    M wide_v;
    const Blocks u = blocks(ring.level, corners(ring, first, &Piece::start_u, &Piece::rate_u),
                            last_cell_.x, outside_u, wide_u);
    const Blocks v = blocks(ring.level, corners(ring, first, &Piece::start_v, &Piece::rate_v),
                            last_cell_.y, outside_v, wide_v);
    wide = hn::Or(wide_u, wide_v);
    outside = hn::Or(outside_u, outside_v);
    if (ring.level == 0) return highest_of_cells(u, v);
    const V columns = of(ring.blocks->columns);
    const auto block = [&](V column, V row) HWY_ATTR {
      const hn::Rebind<float, D> floats;
      const hn::Rebind<std::int32_t, D> ints;
      return hn::GatherIndex(floats, ring.blocks->highest_m.get(),
                             hn::DemoteTo(ints, row * columns + column));
    };
    const auto north = hn::Max(block(u.first, v.first), block(u.last, v.first));
    const auto south = hn::Max(block(u.first, v.last), block(u.last, v.last));
    return hn::PromoteTo(D(), hn::Max(north, south));
  }

  VEC_INLINE V highest_of_cells(const Blocks& u, const Blocks& v) const {
    V highest = of(-std::numeric_limits<double>::infinity());
    for (const V row : {v.first, v.first + of(1), v.last + of(1)})
      for (const V column : {u.first, u.first + of(1), u.last + of(1)}) {
        const V post = posts_.at(row * of(last_cell_.x + 2) + column);
        highest = hn::IfThenElse(post > highest, post, highest);
      }
    return highest;
  }

  // The highest z over the sector. Along an edge z is monotonic in the distance, or bends by less
  // than the slack; and in the azimuth, because no wedge crosses an axis.
  VEC_INLINE V ceiling(const SectorRing& ring, std::size_t first, V height) const {
    if (flat_) return of(z_scale_) * height - of(eye_height_m_);
    const V x_a = hn::Load(D(), edges_.x_a.data() + first);
    const V y_a = hn::Load(D(), edges_.y_a.data() + first);
    const V x_b = hn::Load(D(), edges_.x_b.data() + first);
    const V y_b = hn::Load(D(), edges_.y_b.data() + first);
    const auto at = [&](double distance_m) HWY_ATTR {
      const V s = of(distance_m);
      return hn::Max(frame_.z(x_a * s, y_a * s, height), frame_.z(x_b * s, y_b * s, height));
    };
    return hn::Max(at(ring.near_m), at(ring.far_m));
  }

  VectorFrame frame_;
  VectorPosts posts_;
  bool flat_;
  double margin_cells_;
  glm::dvec2 last_cell_;
  double eye_height_m_;
  double z_scale_;
  const WedgeEdges& edges_;
};

std::size_t bound_sectors(const Terrain& terrain, const WedgeEdges& edges,
                          std::span<const SectorRing> rings, double margin_cells,
                          double highest_slope, float* bounds) {
  const SectorBounds sectors(terrain, edges, margin_cells);
  const hn::Rebind<float, D> floats;
  const std::size_t lanes = hn::Lanes(D());
  std::array<V, EyeFront::kGroup> highest;  // of which kGroup / lanes are used
  std::fill(highest.begin(), highest.end(), of(-std::numeric_limits<double>::infinity()));
  for (std::size_t i = 0; i < rings.size(); ++i) {
    M closed = of(0) == of(0);
    for (std::size_t first = 0; first < EyeFront::kGroup; first += lanes) {
      const V bound = sectors.at(rings[i], first);
      hn::StoreU(hn::DemoteTo(floats, bound), floats, bounds + i * EyeFront::kGroup + first);
      V& so_far = highest[first / lanes];
      so_far = hn::Max(so_far, bound);
      closed = hn::And(closed, so_far > of(highest_slope));
    }
    if (hn::AllTrue(D(), closed)) return i + 1;
  }
  return rings.size();
}

}  // namespace HWY_NAMESPACE
}  // namespace terrview
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace terrview {

HWY_EXPORT(bound_sectors);

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

std::size_t make_bounds(const Terrain& terrain, const WedgeEdges& edges,
                        std::span<const SectorRing> rings, double margin_cells,
                        double highest_slope, float* bounds) {
  return HWY_DYNAMIC_DISPATCH(bound_sectors)(terrain, edges, rings, margin_cells, highest_slope,
                                             bounds);
}

}  // namespace terrview
#endif

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

#include "terrain/sector_bounds.h"
#include "terrain/sector_slopes-inl.h"
#include "terrain/vec_inline.h"
#include "terrain/vector_ground-inl.h"

HWY_BEFORE_NAMESPACE();
namespace terrview {
namespace HWY_NAMESPACE {

class SectorBounds {
 public:
  SectorBounds(const Terrain& terrain, const WedgeEdges& edges, double margin_cells)
      : slopes_(terrain.frame(), edges),
        posts_(*terrain.layers()[0].grid),
        margin_cells_(margin_cells),
        last_cell_(terrain.layers()[0].grid->columns - 2, terrain.layers()[0].grid->rows - 2),
        edges_(edges) {}

  // The bounds of the sectors of lanes `first`, ... of the group.
  VEC_INLINE V at(const SectorRing& ring, std::size_t first) const {
    M outside;
    M wide;
    const V height = highest(ring, first, outside, wide);
    const V bound = slopes_.highest(first, of(ring.near_m), of(ring.far_m), height);
    const V none = of(-std::numeric_limits<double>::infinity());
    const V known = hn::IfThenElse(hn::AndNot(height == none, wide), hn::Inf(D()), bound);
    return hn::IfThenElse(outside, none, known);
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

  SectorSlopes slopes_;
  VectorPosts posts_;
  double margin_cells_;
  glm::dvec2 last_cell_;
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

std::size_t make_bounds(const Terrain& terrain, const WedgeEdges& edges,
                        std::span<const SectorRing> rings, double margin_cells,
                        double highest_slope, float* bounds) {
  return HWY_DYNAMIC_DISPATCH(bound_sectors)(terrain, edges, rings, margin_cells, highest_slope,
                                             bounds);
}

}  // namespace terrview
#endif

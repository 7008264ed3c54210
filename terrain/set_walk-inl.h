// Where the rays of a RaySet stand on their walks over the grid. Included once for every
// instruction set.
#if defined(TERRVIEW_TERRAIN_SET_WALK_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef TERRVIEW_TERRAIN_SET_WALK_INL_H_
#undef TERRVIEW_TERRAIN_SET_WALK_INL_H_
#else
#define TERRVIEW_TERRAIN_SET_WALK_INL_H_
#endif

#include <hwy/highway.h>

#include <array>
#include <cstddef>
#include <cstdint>

#include "terrain/eye_cell.h"
#include "terrain/eye_tracks.h"
#include "terrain/grid_walk.h"
#include "terrain/ray_set.h"
#include "terrain/track_piece.h"
#include "terrain/vec_inline.h"
#include "terrain/vector_ground-inl.h"
#include "terrain/vector_tracks-inl.h"

HWY_BEFORE_NAMESPACE();
namespace terrview {
namespace HWY_NAMESPACE {

VEC_INLINE V load(const EyeRays::Values& values, std::size_t first) {
  return hn::Load(D(), values.data() + first);
}
VEC_INLINE void save(EyeRays::Values& values, std::size_t first, V value) {
  hn::Store(value, D(), values.data() + first);
}

// Walks in their cells. Those `settled` are there as the single ray's walk is.
struct Entry {
  Corners corners;
  M settled;
};

// Where the lanes came into their cells.
VEC_INLINE Entry enter(const VectorGrid& grid, const EyeCell& eye, Registers& r) {
  const M at_eye = hn::And(r.column == of(eye.column), r.row == of(eye.row));
  const Corners corners = grid.corners(r);
  const M entered = grid.enter_cell(r, corners);
  r.g = hn::IfThenElse(at_eye, of(0), r.g);
  r.u = hn::IfThenElse(at_eye, of(eye.u), r.u);
  r.v = hn::IfThenElse(at_eye, of(eye.v), r.v);
  r.z = hn::IfThenElse(at_eye, of(eye.z_m), r.z);
  return {corners, hn::Or(entered, at_eye)};
}

// Where a ray meets the ground, at the share of the way between two crossings.
VEC_INLINE Registers between(const Registers& r, const NextCrossing& next, V share) {
  Registers met = r;
  met.g = r.g + share * (next.g - r.g);
  met.u = r.u + share * (next.u - r.u);
  met.v = r.v + share * (next.v - r.v);
  return met;
}

// Loads pieces, counted from the first ones of tracks, for lines whose directions `r` holds; of
// other lanes than `lanes`, any.
using VectorInts = hn::Vec<hn::Rebind<std::int32_t, D>>;
VEC_INLINE void load_piece(const EyeTracks& tracks, const EyeCell& eye, VectorInts first_piece,
                           VectorInts piece, M lanes, Registers& r) {
  const std::uint32_t wanted = bits_of(lanes);
  const auto [begin, end] = shared_rows<2>(D(), tracks.knots_m().data(), 1, piece, wanted);
  const auto line = shared_rows<EyeTracks::kCoefficients>(
      D(), tracks.coefficients().data(), EyeTracks::kCoefficients, first_piece + piece, wanted);
  r.begin = begin;
  r.end = end;
  r.start_u = of(eye.u) + (line[0] * r.x + line[1] * r.y);
  r.start_v = of(eye.v) + (line[2] * r.x + line[3] * r.y);
  const VectorRate u = invertible(line[4] * r.x + line[5] * r.y);
  const VectorRate v = invertible(line[6] * r.x + line[7] * r.y);
  r.rate_u = u.rate;
  r.rate_v = v.rate;
  r.metres_u = u.metres;
  r.metres_v = v.metres;
}

// The walks of a set's rays, a vector of them at a time. Where the tracks of the terrain bend,
// kBent.
template <bool kBent>
class SetWalk {
 public:
  // Rays begin `step_back_m` before a knot that parts them from the start of their cell.
  SetWalk(const Terrain& terrain, RaySet& set, double step_back_m)
      : terrain_(terrain),
        grid_(terrain),
        set_(set),
        step_back_m_(step_back_m),
        tracks_(terrain.layers()[0].map->eye_tracks()),
        eye_(terrain) {}

  [[nodiscard]] const VectorGrid& grid() const { return grid_; }

  // Rays first, first + 1, ... of the set before their walks.
  VEC_INLINE Registers lines(std::size_t first) const {
    Registers r;
    r.x = load(set_.x, first);
    r.y = load(set_.y, first);
    r.slope = load(set_.slope, first);
    r.rate_u = load(set_.rate_u, first);
    r.rate_v = load(set_.rate_v, first);
    r.metres_u = load(set_.metres_u, first);
    r.metres_v = load(set_.metres_v, first);
    r.begin = of(0);
    r.end = of(terrain_.reach_m());
    r.start_u = of(eye_.u);
    r.start_v = of(eye_.v);
    r.column = r.row = r.g = r.u = r.v = r.z = of(0);
    return r;
  }

  // The walk as it stands at rays first, first + 1, ... of the set.
  VEC_INLINE Registers at(std::size_t first) const {
    Registers r = lines(first);
    if constexpr (kBent) {
      r.begin = load(set_.begin, first);
      r.end = load(set_.end, first);
      r.start_u = load(set_.start_u, first);
      r.start_v = load(set_.start_v, first);
    }
    r.column = load(set_.column, first);
    r.row = load(set_.row, first);
    r.g = load(set_.g, first);
    r.u = load(set_.u, first);
    r.v = load(set_.v, first);
    r.z = load(set_.z, first);
    return r;
  }

  VEC_INLINE void keep(const Registers& r, std::size_t first) {
    save(set_.column, first, r.column);
    save(set_.row, first, r.row);
    save(set_.g, first, r.g);
    save(set_.u, first, r.u);
    save(set_.v, first, r.v);
    save(set_.z, first, r.z);
  }

  // Where tracks bend, after settling.
  VEC_INLINE void keep_pieces(const Registers& r, std::size_t first) {
    save(set_.begin, first, r.begin);
    save(set_.end, first, r.end);
    save(set_.start_u, first, r.start_u);
    save(set_.start_v, first, r.start_v);
    save(set_.rate_u, first, r.rate_u);
    save(set_.rate_v, first, r.rate_v);
    save(set_.metres_u, first, r.metres_u);
    save(set_.metres_v, first, r.metres_v);
  }

  // Puts the wanted lanes of rays first, first + 1, ... into the cells where they are at a
  // distance, or a little before.
  VEC_INLINE Entry settle(Registers& r, std::size_t first, V start_m, M wanted) const {
    Registers to = r;
    if constexpr (kBent) load_pieces(to, first, start_m, wanted);
    M seated = seat(to, start_m);
    Entry entry = enter(grid_, eye_, to);
    entry.settled = hn::And(entry.settled, seated);
    if constexpr (kBent) {
      // A cell that was entered on the piece before is too late to begin with.
      const M early =
          hn::And(hn::And(wanted, seated), hn::And(hn::Not(entry.settled), to.begin > of(0)));
      if (bits_of(early) != 0) {
        Registers back = r;
        const V before_m = hn::Max(to.begin - of(step_back_m_), of(0));
        load_pieces(back, first, before_m, early);
        seated = seat(back, before_m);
        const Entry earlier = enter(grid_, eye_, back);
        entry.settled = hn::Or(entry.settled, hn::And(early, hn::And(earlier.settled, seated)));
        choose_piece(to, early, back);
        choose(to, early, back);
        entry.corners = grid_.corners(to);
      }
      choose_piece(r, wanted, to);
    }
    choose(r, wanted, to);
    return entry;
  }

  // Takes the walk of `other` where `mask`.
  VEC_INLINE void choose(Registers& r, M mask, const Registers& other) const {
    r.column = hn::IfThenElse(mask, other.column, r.column);
    r.row = hn::IfThenElse(mask, other.row, r.row);
    r.g = hn::IfThenElse(mask, other.g, r.g);
    r.u = hn::IfThenElse(mask, other.u, r.u);
    r.v = hn::IfThenElse(mask, other.v, r.v);
    r.z = hn::IfThenElse(mask, other.z, r.z);
  }

  // Ray i of the set goes on along the next piece of its track, in the same cell.
  void next_piece(std::size_t i) {
    put_piece(set_, i, tracks_->piece({set_.x[i], set_.y[i]}, set_.end[i], terrain_.reach_m()));
  }

  // Of lanes that have left the grid, those whose tracks come back.
  [[nodiscard]] std::uint32_t returning(std::size_t first, std::uint32_t outside) const {
    std::uint32_t back = 0;
    const TerrainLayer& layer = terrain_.layers()[0];
    const double reach_m = terrain_.reach_m();
    for (std::uint32_t left = outside; left != 0; left &= left - 1) {
      const auto i = first + static_cast<std::size_t>(__builtin_ctz(left));
      if (set_.end[i] >= reach_m) continue;
      const GroundLine line{{0, 0}, {set_.x[i], set_.y[i]}};
      GridWalk walk(*layer.grid, *layer.map, terrain_.model(), line, set_.end[i], reach_m);
      if (walk.over_grid()) back |= 1U << __builtin_ctz(left);
    }
    return back;
  }

 private:
  VEC_INLINE void choose_piece(Registers& r, M mask, const Registers& other) const {
    r.begin = hn::IfThenElse(mask, other.begin, r.begin);
    r.end = hn::IfThenElse(mask, other.end, r.end);
    r.start_u = hn::IfThenElse(mask, other.start_u, r.start_u);
    r.start_v = hn::IfThenElse(mask, other.start_v, r.start_v);
    r.rate_u = hn::IfThenElse(mask, other.rate_u, r.rate_u);
    r.rate_v = hn::IfThenElse(mask, other.rate_v, r.rate_v);
    r.metres_u = hn::IfThenElse(mask, other.metres_u, r.metres_u);
    r.metres_v = hn::IfThenElse(mask, other.metres_v, r.metres_v);
  }

  // Loads the pieces of the tracks that distances lie on.
  VEC_INLINE void load_pieces(Registers& r, std::size_t first, V from_m, M lanes) const {
    const V piece = pieces_at(D(), tracks_->knots_m(), hn::IfThenElseZero(lanes, from_m));
    const hn::Rebind<std::int32_t, D> ints;
    load_piece(*tracks_, eye_, hn::DemoteTo(ints, load(set_.sector, first) * of(tracks_->pieces())),
               hn::DemoteTo(ints, piece), lanes, r);
  }

  // Puts rays into their cells at a distance. False: that is not over the grid.
  VEC_INLINE M seat(Registers& r, V start_m) const {
    const V u = r.start_u + r.rate_u * (start_m - r.begin);
    const V v = r.start_v + r.rate_v * (start_m - r.begin);
    const V last_column = grid_.columns() - of(2);
    const V last_row = grid_.rows() - of(2);
    // Lanes without a ray may hold NaN.
    r.column = hn::IfThenElseZero(u >= of(0), hn::Min(hn::Floor(u), last_column));
    r.row = hn::IfThenElseZero(v >= of(0), hn::Min(hn::Floor(v), last_row));
    return hn::And(hn::And(u >= of(0), v >= of(0)),
                   hn::And(u <= last_column + of(1), v <= last_row + of(1)));
  }

  const Terrain& terrain_;
  VectorGrid grid_;
  RaySet& set_;
  double step_back_m_;
  const EyeTracks* tracks_;
  EyeCell eye_;
};

}  // namespace HWY_NAMESPACE
}  // namespace terrview
HWY_AFTER_NAMESPACE();

#endif

// The cells that rays are thought to meet the ground in, looked at in doubles with the arithmetic
// of the single ray. Included once for every instruction set.
#if defined(TERRVIEW_TERRAIN_EYE_PROOF_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef TERRVIEW_TERRAIN_EYE_PROOF_INL_H_
#undef TERRVIEW_TERRAIN_EYE_PROOF_INL_H_
#else
#define TERRVIEW_TERRAIN_EYE_PROOF_INL_H_
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

#include "terrain/eye_cell.h"
#include "terrain/eye_tracer.h"
#include "terrain/scout_set.h"
#include "terrain/set_walk-inl.h"
#include "terrain/vec_inline.h"
#include "terrain/vector_ground-inl.h"
#include "terrain/vector_sectors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace terrview {
namespace HWY_NAMESPACE {

// Where tracks bend, kBent.
template <bool kBent>
class EyeProof {
 public:
  EyeProof(const Terrain& terrain, EyeRays& rays, ScoutFinds& finds)
      : grid_(terrain),
        eye_(terrain),
        jacobian_(terrain.layers()[0].map->linear()),
        tracks_(terrain.layers()[0].map->eye_tracks()),
        reach_m_(terrain.reach_m()),
        rays_(rays),
        finds_(finds) {}

  // Writes the hits; rays whose cell proves another are unsure.
  void run() {
    for (std::size_t i = 0; i < rays_.count; i += hn::Lanes(D())) aim(i);
    for (std::size_t i = 0; i < rays_.count; i += hn::Lanes(D())) prove(i);
  }

 private:
  using IntTag = hn::Rebind<std::int32_t, D>;

  static VEC_INLINE V cells(const ScoutSet::Floats& values, std::size_t first) {
    return hn::PromoteTo(D(), hn::LoadU(hn::Rebind<float, D>(), values.data() + first));
  }

  // Lines come first, all of them: what is found on them need not wait.
  VEC_INLINE void aim(std::size_t first) {
    if (hn::AllFalse(D(), cells(finds_.column, first) >= of(0))) return;
    const VectorLine line =
        line_under(load(rays_.direction_x, first), load(rays_.direction_y, first),
                   load(rays_.direction_z, first));
    save(rays_.x, first, line.x);
    save(rays_.y, first, line.y);
    save(rays_.slope, first, line.slope);
    if constexpr (kBent) {
      const V sector = sectors_of(D(), line.x, line.y, tracks_->sectors_a_side());
      hn::Store(hn::DemoteTo(IntTag(), sector * of(tracks_->pieces())), IntTag(),
                first_piece_.data() + first);
    }
  }

  VEC_INLINE void prove(std::size_t first) {
    const V column = cells(finds_.column, first);
    const M found = column >= of(0);
    if (hn::AllFalse(D(), found)) {
      save(rays_.ground_m, first, of(-1));
      return;
    }
    Registers r;
    r.x = load(rays_.x, first);
    r.y = load(rays_.y, first);
    r.slope = load(rays_.slope, first);
    r.column = hn::IfThenElseZero(found, column);
    r.row = hn::IfThenElseZero(found, cells(finds_.row, first));
    const Entry entry = lay(r, found, first);
    const Corners& corners = entry.corners;
    const NextCrossing next = grid_.next_crossing(r, corners);
    const V in = r.slope * r.g - r.z;
    const V out = r.slope * next.g - next.z;
    const M meets = hn::And(hn::And(in >= of(0), out <= of(0)), next.g > r.g);
    const M whole = hn::And(next.has_ground, hn::Not(next.g > r.end));
    const M hit = hn::And(hn::And(found, entry.settled), hn::And(whole, meets));
    const V share = hn::IfThenElseZero(in > of(0), in / (in - out));
    const Registers met = between(r, next, share);
    save(rays_.ground_m, first, hn::IfThenElse(hit, met.g, of(-1)));
    save(rays_.u, first, met.u);
    save(rays_.v, first, met.v);
    save(rays_.column, first, r.column);
    save(rays_.row, first, r.row);
    for (std::uint32_t left = bits_of(hn::AndNot(hit, found)); left != 0; left &= left - 1)
      finds_.doubt(first + static_cast<std::size_t>(__builtin_ctz(left)), 0);
  }

  // The lines, or their pieces, from where they come into the cells.
  VEC_INLINE Entry lay(Registers& r, M found, std::size_t first) const {
    if constexpr (kBent) return lay_pieces(r, found, first);
    const LinearRates rates = rates_along({r.x, r.y, r.slope}, *jacobian_);
    r.begin = of(0);
    r.end = of(reach_m_);
    r.start_u = of(eye_.u);
    r.start_v = of(eye_.v);
    r.rate_u = rates.u.rate;
    r.rate_v = rates.v.rate;
    r.metres_u = rates.u.metres;
    r.metres_v = rates.v.metres;
    return enter(grid_, eye_, r);
  }

  VEC_INLINE Entry lay_pieces(Registers& r, M found, std::size_t first) const {
    const auto first_piece = hn::Load(IntTag(), first_piece_.data() + first);
    const auto piece = hn::Load(IntTag(), finds_.piece.data() + first);
    load_piece(*tracks_, eye_, first_piece, piece, found, r);
    Entry entry = enter(grid_, eye_, r);
    const M early = hn::And(hn::AndNot(entry.settled, found), r.begin > of(0));
    if (hn::AllFalse(D(), early)) return entry;
    // The cells in which a knot lies were come into along the piece before.
    Registers before = r;
    load_piece(*tracks_, eye_, first_piece, piece - hn::Set(IntTag(), 1), early, before);
    const M entered = enter(grid_, eye_, before).settled;
    const M has_knot =
        hn::And(before.g <= before.end, grid_.next_crossing(before, entry.corners).g > before.end);
    const M over_knot = hn::And(hn::And(early, entered), has_knot);
    r.g = hn::IfThenElse(over_knot, before.g, r.g);
    r.u = hn::IfThenElse(over_knot, before.u, r.u);
    r.v = hn::IfThenElse(over_knot, before.v, r.v);
    r.z = hn::IfThenElse(over_knot, before.z, r.z);
    entry.settled = hn::Or(entry.settled, over_knot);
    return entry;
  }

  VectorGrid grid_;
  EyeCell eye_;
  const glm::dmat2* jacobian_;
  const EyeTracks* tracks_;
  double reach_m_;
  EyeRays& rays_;
  ScoutFinds& finds_;
  alignas(64) ScoutSet::Ints first_piece_;  // of bent tracks
};

}  // namespace HWY_NAMESPACE
}  // namespace terrview
HWY_AFTER_NAMESPACE();

#endif

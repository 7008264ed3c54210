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
        map_(*terrain.layers()[0].map),
        reach_m_(terrain.reach_m()),
        rays_(rays),
        finds_(finds) {}

  // Writes the hits; rays whose cell proves another are unsure.
  void run() {
    for (std::size_t i = 0; i < rays_.count; i += hn::Lanes(D())) prove(i);
  }

 private:
  static VEC_INLINE V cells(const ScoutSet::Floats& values, std::size_t first) {
    return hn::PromoteTo(D(), hn::LoadU(hn::Rebind<float, D>(), values.data() + first));
  }

  VEC_INLINE void prove(std::size_t first) {
    const V column = cells(finds_.column, first);
    const M found = column >= of(0);
    if (hn::AllFalse(D(), found)) {
      save(rays_.ground_m, first, of(-1));
      return;
    }
    const VectorLine line =
        line_under(load(rays_.direction_x, first), load(rays_.direction_y, first),
                   load(rays_.direction_z, first));
    Registers r;
    r.x = line.x;
    r.y = line.y;
    r.slope = line.slope;
    lay(r, found, first);
    r.column = hn::IfThenElseZero(found, column);
    r.row = hn::IfThenElseZero(found, cells(finds_.row, first));
    const auto [corners, settled] = enter(grid_, eye_, r);
    const NextCrossing next = grid_.next_crossing(r, corners);
    const V in = r.slope * r.g - r.z;
    const V out = r.slope * next.g - next.z;
    const M meets = hn::And(hn::And(in >= of(0), out <= of(0)), next.g > r.g);
    const M whole = hn::And(next.has_ground, hn::Not(next.g > r.end));
    const M hit = hn::And(hn::And(found, settled), hn::And(whole, meets));
    const V share = hn::IfThenElseZero(in > of(0), in / (in - out));
    const Registers met = between(r, next, share);
    save(rays_.x, first, line.x);
    save(rays_.y, first, line.y);
    save(rays_.slope, first, line.slope);
    save(rays_.ground_m, first, hn::IfThenElse(hit, met.g, of(-1)));
    save(rays_.u, first, met.u);
    save(rays_.v, first, met.v);
    save(rays_.column, first, r.column);
    save(rays_.row, first, r.row);
    for (std::uint32_t left = bits_of(hn::AndNot(hit, found)); left != 0; left &= left - 1)
      finds_.doubt(first + static_cast<std::size_t>(__builtin_ctz(left)), 0);
  }

  // The line, or its piece.
  VEC_INLINE void lay(Registers& r, M found, std::size_t first) const {
    if constexpr (kBent) {
      const EyeTracks& tracks = *map_.eye_tracks();
      const V piece =
          hn::PromoteTo(D(), hn::LoadU(hn::Rebind<std::int32_t, D>(), finds_.piece.data() + first));
      const V sector = sectors_of(D(), r.x, r.y, tracks.sectors_a_side());
      load_piece(tracks, eye_, sector, hn::IfThenElseZero(found, piece), r);
    } else {
      const LinearRates rates = rates_along({r.x, r.y, r.slope}, *map_.linear());
      r.begin = of(0);
      r.end = of(reach_m_);
      r.start_u = of(eye_.u);
      r.start_v = of(eye_.v);
      r.rate_u = rates.u.rate;
      r.rate_v = rates.v.rate;
      r.metres_u = rates.u.metres;
      r.metres_v = rates.v.metres;
    }
  }

  VectorGrid grid_;
  EyeCell eye_;
  const GroundMap& map_;
  double reach_m_;
  EyeRays& rays_;
  ScoutFinds& finds_;
};

}  // namespace HWY_NAMESPACE
}  // namespace terrview
HWY_AFTER_NAMESPACE();

#endif

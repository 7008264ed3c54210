// Rays from the eye look for the cells in which they meet the ground. Included once for every
// instruction set.
#if defined(TERRVIEW_TERRAIN_EYE_SCOUT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef TERRVIEW_TERRAIN_EYE_SCOUT_INL_H_
#undef TERRVIEW_TERRAIN_EYE_SCOUT_INL_H_
#else
#define TERRVIEW_TERRAIN_EYE_SCOUT_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <glm/mat2x2.hpp>

#include "terrain/eye_front.h"
#include "terrain/eye_tracks.h"
#include "terrain/front_search-inl.h"
#include "terrain/scout_lines-inl.h"
#include "terrain/scout_set.h"
#include "terrain/scout_walk-inl.h"
#include "terrain/vec_inline.h"
#include "terrain/vector_sectors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace terrview {
namespace HWY_NAMESPACE {

template <Ground kGround>
class EyeScout {
 public:
  EyeScout(const EyeFront& front, const EyeRays& rays, ScoutFinds& finds)
      : front_(front),
        rays_(rays),
        finds_(finds),
        search_(front),
        lines_(front.terrain()),
        walk_(front.terrain(), lines_.posts_per_m(), front.margin_m()) {}

  // Returns how many cells were compared with rays.
  std::int64_t run() {
    for (std::size_t first = 0; first < rays_.count; first += kLanes) aim(first);
    for (std::size_t first = 0; first < rays_.count; first += kLanes) begin(first);
    while (set_.count > 0) {
      const std::size_t count = set_.count;
      set_.count = 0;
      for (std::size_t first = 0; first < count; first += kLanes)
        go_on(first, (1U << std::min(kLanes, count - first)) - 1);
    }
    return walk_.tests();
  }

 private:
  using Walker = ScoutWalk<kGround>;
  using Walk = typename Walker::Walk;
  using Fates = typename Walker::Fates;
  using F = typename Walker::F;
  using I = typename Walker::I;
  using VF = typename Walker::VF;
  using VI = typename Walker::VI;
  using MF = typename Walker::MF;
  static constexpr std::size_t kLanes = hn::MaxLanes(F());
  static constexpr bool kBent = kGround == Ground::bent;

  // A ray on its way.
  struct Scout {
    Walk w;
    VI index, wedge, first_piece, piece;
    VF x, y;
  };

  static VEC_INLINE VF of(float x) { return hn::Set(F(), x); }
  static VEC_INLINE VI of_int(std::int32_t x) { return hn::Set(I(), x); }
  static VEC_INLINE MF no_lanes() { return of(0) > of(0); }

  static VEC_INLINE VF as_floats(const EyeRays::Values& values, std::size_t first) {
#if HWY_TARGET == HWY_SCALAR
    return of(static_cast<float>(values[first]));
#else
    const hn::Half<F> half;
    const hn::Rebind<double, hn::Half<F> > doubles;
    const double* from = values.data() + first;
    return hn::Combine(F(), hn::DemoteTo(half, hn::LoadU(doubles, from + kLanes / 2)),
                       hn::DemoteTo(half, hn::LoadU(doubles, from)));
#endif
  }

  // What is kept of a ray but for its index and its cell.
  template <class VisitFloats, class VisitInts>
  VEC_INLINE void visit(Scout& s, const VisitFloats& floats, const VisitInts& ints) {
    ints(s.wedge, set_.wedge);
    floats(s.w.slope, set_.slope);
    floats(s.w.g, set_.g);
    if constexpr (kGround != Ground::flat) floats(s.w.curvature, set_.curvature);
    if constexpr (kBent) {
      floats(s.x, set_.x);
      floats(s.y, set_.y);
      ints(s.first_piece, set_.first_piece);
      ints(s.piece, set_.piece);
    } else {
      floats(s.w.rate_u, set_.rate_u);
      floats(s.w.rate_v, set_.rate_v);
      floats(s.w.metres_u, set_.metres_u);
      floats(s.w.metres_v, set_.metres_v);
    }
  }

  VEC_INLINE Scout load(std::size_t first) {
    Scout s;
    visit(
        s,
        [&](VF& value, const ScoutSet::Floats& values)
            HWY_ATTR { value = hn::Load(F(), values.data() + first); },
        [&](VI& value, const ScoutSet::Ints& values)
            HWY_ATTR { value = hn::Load(I(), values.data() + first); });
    if constexpr (!kBent) {
      s.w.base_u = walk_.eye_u();
      s.w.base_v = walk_.eye_v();
    }
    s.w.column = s.w.row = of(0);
    return s;
  }

  // Finds where rays first, first + 1, ... may first meet the ground. NaN: floats can't tell.
  VEC_INLINE void aim(std::size_t first) {
    if (rays_.follows && !any_goes_on(as_floats(rays_.clear_m, first))) {
      hn::Store(hn::Inf(F()), F(), set_.g.data() + first);
      return;
    }
    Scout s;
    const VF across_x = as_floats(rays_.direction_x, first);
    const VF across_y = as_floats(rays_.direction_y, first);
    const VF up = as_floats(rays_.direction_z, first);
    const VF across2 = across_x * across_x + across_y * across_y;
    constexpr float kSteepest = 1e4F;
    MF is_sure = across2 * of(kSteepest * kSteepest) > up * up;
    const VF inverse = of(1) / hn::Sqrt(across2);
    s.x = across_x * inverse;
    s.y = across_y * inverse;
    s.w.slope = up * inverse;
    s.wedge = hn::ConvertTo(I(), sectors_of(F(), s.x, s.y, front_.wedges_a_side()));
    make_groups(hn::ShiftRight<EyeFront::kGroupBits>(s.wedge));
    s.w.g = search_.start_m(start_of(s));
    if (rays_.follows) s.w.g = hn::Max(s.w.g, safely(as_floats(rays_.clear_m, first)));
    if constexpr (kGround != Ground::flat) s.w.curvature = walk_.curvature(s.x, s.y);
    if constexpr (kBent) {
      s.first_piece = lines_.first_piece(s.x, s.y);
      s.piece = lines_.piece_at(hn::IfThenElseZero(s.w.g < hn::Inf(F()), s.w.g));
    } else {
      lines_.lay(s.w, s.x, s.y);
      // Along a line of posts floats would not know the side.
      is_sure = hn::And(is_sure, hn::And(s.w.rate_u != of(0), s.w.rate_v != of(0)));
    }
    s.w.g = hn::IfThenElse(is_sure, s.w.g, hn::NaN(F()));
    visit(
        s,
        [&](VF& value, ScoutSet::Floats& values)
            HWY_ATTR { hn::Store(value, F(), values.data() + first); },
        [&](VI& value, ScoutSet::Ints& values)
            HWY_ATTR { hn::Store(value, I(), values.data() + first); });
  }

  // The place in the front's starts.
  VEC_INLINE VI start_of(const Scout& s) const {
    constexpr float kHalfway = EyeFront::kHalfwaySlope;
    const VF bin = (s.w.slope / (of(kHalfway) + hn::Abs(s.w.slope)) + of(1)) *
                   of(static_cast<float>(EyeFront::kStartBins / 2));
    const VI known = hn::Min(hn::Max(hn::ConvertTo(I(), bin), of_int(front_.first_bin())),
                             of_int(front_.last_bin()));
    return hn::ShiftLeft<EyeFront::kStartBinBits>(s.wedge) + known;
  }

  // Makes the groups of wedges that have not been made.
  VEC_INLINE void make_groups(VI groups) {
    const VI beside = hn::Or(groups - of_int(first_made_), of_int(last_made_) - groups);
    if (hn::AllFalse(I(), beside < of_int(0))) return;
    alignas(64) std::array<std::int32_t, 16> lanes;
    hn::Store(groups, I(), lanes.data());
    for (std::size_t lane = 0; lane < kLanes; ++lane) make_group(lanes[lane]);
  }

  void make_group(std::int32_t group) {
    if (group >= first_made_ && group <= last_made_) return;
    front_.make(group);
    if (group == last_made_ + 1)
      last_made_ = group;
    else if (group == first_made_ - 1)
      first_made_ = group;
    else
      first_made_ = last_made_ = group;
  }

  // A distance up to which a ray is clear where it is up to this one, which may be off by rounding.
  VEC_INLINE VF safely(VF clear_m) const {
    constexpr float kRounding = 0x1p-20F;
    return clear_m * of(1 - kRounding) - of(static_cast<float>(front_.margin_m()));
  }

  // Whether one of these distances is not infinite: there is something to meet beyond.
  static VEC_INLINE bool any_goes_on(VF clear_m) {
    return !hn::AllTrue(F(), clear_m == hn::Inf(F()));
  }

  // Rays first, first + 1, ... through their first cells.
  VEC_INLINE void begin(std::size_t first) {
    if (!any_goes_on(hn::Load(F(), set_.g.data() + first))) {
      hn::Store(of(-1), F(), finds_.column.data() + first);
      return;
    }
    const MF here = mask_from(F(), (1U << std::min(kLanes, rays_.count - first)) - 1);
    Scout s = load(first);
    s.index = of_int(static_cast<std::int32_t>(first)) + hn::Iota(I(), 0);
    Fates fates;
    const MF is_sure = s.w.g == s.w.g;
    fates.unsure = hn::AndNot(is_sure, here);
    fates.active = hn::And(hn::And(is_sure, here), s.w.g < hn::Inf(F()));
    fates.hit = fates.at_knot = no_lanes();
    if constexpr (kBent) lines_.lay(s.w, s.x, s.y, s.first_piece, s.piece, fates.active);
    walk_.seat(s.w, fates);
    walk_.cross_cells(s.w, fates);
    hn::Store(hn::IfThenElse(fates.hit, walk_.column_of(s.w), of(-1)), F(),
              finds_.column.data() + first);
    hn::Store(walk_.row_of(s.w), F(), finds_.row.data() + first);
    if constexpr (kBent) hn::Store(s.piece, I(), finds_.piece.data() + first);
    keep(s, fates);
  }

  // Further cells of rays first, first + 1, ... of the set.
  VEC_INLINE void go_on(std::size_t first, std::uint32_t lanes) {
    Scout s = load(first);
    s.w.column = hn::Load(F(), set_.column.data() + first);
    s.w.row = hn::Load(F(), set_.row.data() + first);
    s.index = hn::Load(I(), set_.index.data() + first);
    Fates fates;
    fates.active = mask_from(F(), lanes);
    fates.hit = fates.unsure = fates.at_knot = no_lanes();
    look_ahead(s, fates);
    walk_.cross_cells(s.w, fates);
    put_hits(s, mask_bits(F(), fates.hit));
    keep(s, fates);
  }

  // Takes rays over the sectors that they clear; those that clear all there are have missed.
  VEC_INLINE void look_ahead(Scout& s, Fates& fates) const {
    // Past the last ray lies anything.
    const VI wedge = hn::IfThenElseZero(hn::RebindMask(I(), fates.active), s.wedge);
    const VI here = search_.ring_of(s.w.g);
    const auto there = search_.next(here, s.w.slope, wedge, fates.active);
    fates.active = hn::AndNot(search_.is_none(there.ring), fates.active);
    const MF further = hn::RebindMask(F(), there.ring > here);
    const MF leaps = hn::And(hn::And(further, there.start_m > s.w.g), fates.active);
    const bool none_leaps = hn::AllFalse(F(), leaps);
    if (none_leaps && !kBent) return;
    Walk to = s.w;
    to.g = hn::IfThenElse(leaps, there.start_m, s.w.g);
    if constexpr (kBent) {
      const VI piece = lines_.piece_at(to.g);
      s.piece = hn::IfThenElse(hn::RebindMask(I(), leaps), piece, s.piece);
      lines_.lay(to, s.x, s.y, s.first_piece, s.piece, fates.active);
    }
    Fates leaping{leaps, fates.hit, no_lanes(), no_lanes()};
    walk_.seat(to, leaping);
    to.column = hn::IfThenElse(leaps, to.column, s.w.column);
    to.row = hn::IfThenElse(leaps, to.row, s.w.row);
    s.w = to;
    fates.unsure = hn::Or(fates.unsure, leaping.unsure);
    fates.active = hn::AndNot(leaping.unsure, fates.active);
  }

  void put_hits(const Scout& s, std::uint32_t hits) {
    if (hits == 0) return;
    alignas(64) std::array<float, 16> columns;
    alignas(64) std::array<float, 16> rows;
    alignas(64) std::array<std::int32_t, 16> indices;
    alignas(64) std::array<std::int32_t, 16> pieces;
    hn::Store(walk_.column_of(s.w), F(), columns.data());
    hn::Store(walk_.row_of(s.w), F(), rows.data());
    hn::Store(s.index, I(), indices.data());
    if constexpr (kBent) hn::Store(s.piece, I(), pieces.data());
    for (; hits != 0; hits &= hits - 1) {
      const auto lane = static_cast<std::size_t>(__builtin_ctz(hits));
      const auto i = static_cast<std::size_t>(indices[lane]);
      finds_.column[i] = columns[lane];
      finds_.row[i] = rows[lane];
      if constexpr (kBent) finds_.piece[i] = pieces[lane];
    }
  }

  // Puts by what is left to do. The set has room: it never grows beyond what was read of it.
  VEC_INLINE void keep(Scout& s, Fates& fates) {
    if constexpr (kBent) {
      s.w.g = hn::IfThenElse(fates.at_knot, s.w.end, s.w.g);
      s.piece = s.piece + hn::IfThenElseZero(hn::RebindMask(I(), fates.at_knot), of_int(1));
      // No piece follows the last.
      const MF last = hn::RebindMask(F(), s.piece > of_int(lines_.pieces() - 1));
      fates.unsure = hn::Or(fates.unsure, hn::And(fates.at_knot, last));
      fates.active = hn::Or(fates.active, hn::AndNot(last, fates.at_knot));
    }
    put_doubts(s, mask_bits(F(), fates.unsure));
    const std::uint32_t active = mask_bits(F(), fates.active);
    if (active == 0) return;
    const std::size_t to = set_.count;
    const auto floats = [&](VF& value, ScoutSet::Floats& values) HWY_ATTR {
      hn::StoreU(hn::Compress(value, fates.active), F(), values.data() + to);
    };
    const auto ints = [&](VI& value, ScoutSet::Ints& values) HWY_ATTR {
      hn::StoreU(hn::Compress(value, hn::RebindMask(I(), fates.active)), I(), values.data() + to);
    };
    visit(s, floats, ints);
    ints(s.index, set_.index);
    floats(s.w.column, set_.column);
    floats(s.w.row, set_.row);
    set_.count += static_cast<std::size_t>(__builtin_popcount(active));
  }

  void put_doubts(const Scout& s, std::uint32_t unsure) {
    if (unsure == 0) return;
    alignas(64) std::array<std::int32_t, 16> indices;
    alignas(64) std::array<float, 16> clear_m;
    hn::Store(s.index, I(), indices.data());
    const VF safe_m = safely(s.w.g);
    hn::Store(hn::IfThenElseZero(safe_m > of(0), safe_m), F(), clear_m.data());
    for (; unsure != 0; unsure &= unsure - 1) {
      const auto lane = static_cast<std::size_t>(__builtin_ctz(unsure));
      finds_.doubt(static_cast<std::size_t>(indices[lane]), clear_m[lane]);
    }
  }

  const EyeFront& front_;
  const EyeRays& rays_;
  ScoutFinds& finds_;
  FrontSearch<F> search_;
  ScoutLines<kGround> lines_;
  Walker walk_;
  // Groups of wedges that are known to be made, from the first to the last.
  std::int32_t first_made_ = 0;
  std::int32_t last_made_ = -1;
  ScoutSet set_;
};

}  // namespace HWY_NAMESPACE
}  // namespace terrview
HWY_AFTER_NAMESPACE();

#endif

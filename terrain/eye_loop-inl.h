// The walk of a batch of rays from the eye, in vectors. Included once for every instruction set.
#if defined(TERRVIEW_TERRAIN_EYE_LOOP_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef TERRVIEW_TERRAIN_EYE_LOOP_INL_H_
#undef TERRVIEW_TERRAIN_EYE_LOOP_INL_H_
#else
#define TERRVIEW_TERRAIN_EYE_LOOP_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "terrain/eye_front.h"
#include "terrain/eye_tracer.h"
#include "terrain/front_search-inl.h"
#include "terrain/ray_set.h"
#include "terrain/set_walk-inl.h"
#include "terrain/vec_inline.h"
#include "terrain/vector_ground-inl.h"

HWY_BEFORE_NAMESPACE();
namespace terrview {
namespace HWY_NAMESPACE {

// Where the tracks of a terrain bend, kBent.
template <bool kBent>
class EyeLoop {
 public:
  EyeLoop(const EyeFront& front, EyeRays& rays, RaySet& set, RescueList& rescues)
      : front_(front),
        rays_(rays),
        set_(set),
        rescues_(rescues),
        search_(front),
        walk_(front.terrain(), set, front.step_back_m()) {}

  std::int64_t run() {
    constexpr int kSteps = 3;
    pass([&](std::size_t i, std::uint32_t lanes) HWY_ATTR { return begin(i, lanes); });
    while (set_.count > 0) {
      for (int j = 0; j < kSteps; ++j)
        pass([&](std::size_t i, std::uint32_t lanes) HWY_ATTR { return step(i, lanes); });
      pass([&](std::size_t i, std::uint32_t lanes) HWY_ATTR { return look_ahead(i, lanes); });
    }
    return tests_;
  }

 private:
  using FloatTag = hn::Rebind<float, D>;
  using IntTag = hn::Rebind<std::int32_t, D>;
  using Ints = hn::Vec<IntTag>;

  // Takes each vector of rays, and moves those that go on to the front of the set.
  template <class Take>
  VEC_INLINE void pass(const Take& take) {
    std::size_t kept = 0;
    for (std::size_t first = 0; first < set_.count; first += hn::Lanes(D())) {
      const std::uint32_t lanes = (1U << std::min(hn::Lanes(D()), set_.count - first)) - 1;
      const std::uint32_t left = take(first, lanes);
      if (left == 0) continue;
      if (left != lanes || kept != first) move(first, left, kept);
      kept += static_cast<std::size_t>(__builtin_popcount(left));
    }
    set_.count = kept;
  }

  VEC_INLINE void move(std::size_t first, std::uint32_t lanes, std::size_t to) {
    const auto order = hn::IndicesFromVec(D(), set_lanes(lanes));
    const auto take = [&](EyeRays::Values& values) HWY_ATTR {
      hn::StoreU(hn::TableLookupLanes(load(values, first), order), D(), values.data() + to);
    };
    for (EyeRays::Values* values : set_.walks()) take(*values);
    if constexpr (kBent)
      for (EyeRays::Values* values : set_.pieces()) take(*values);
  }

  // The numbers of the lanes, lowest first.
  static VEC_INLINE auto set_lanes(std::uint32_t lanes) {
    const hn::Rebind<std::uint8_t, D> bytes;
    const hn::Rebind<std::int32_t, D> ints;
    const hn::Rebind<std::int64_t, D> longs;
    return hn::PromoteTo(longs, hn::PromoteTo(ints, hn::LoadU(bytes, kSetBits[lanes].data())));
  }

  VEC_INLINE void rescue(std::size_t first, std::uint32_t lanes) {
    for (; lanes != 0; lanes &= lanes - 1) {
      const auto i = first + static_cast<std::size_t>(__builtin_ctz(lanes));
      rescues_.rays[rescues_.count++] = static_cast<std::int32_t>(set_.index[i]);
    }
  }

  // Takes rays first, first + 1, ..., which are those of EyeRays in order, through the first cells
  // that they need look at.
  VEC_INLINE std::uint32_t begin(std::size_t first, std::uint32_t lanes) {
    save(rays_.ground_m, first, of(-1));
    const M slanted = is_slanted(load(rays_.direction_x, first), load(rays_.direction_y, first),
                                 load(rays_.direction_z, first));
    V start_m =
        hn::PromoteTo(D(), search_.start_m(hn::DemoteTo(IntTag(), load(set_.start, first))));
    if (rays_.follows) start_m = hn::Max(start_m, load(rays_.clear_m, first));
    const M meets = start_m < hn::Inf(D());
    std::uint32_t lost = lanes & ~bits_of(slanted);
    std::uint32_t active = lanes & bits_of(meets) & ~lost;
    if ((active | lost) == 0) return 0;
    Registers r = walk_.lines(first);
    const auto [corners, settled] =
        walk_.settle(r, first, hn::IfThenElseZero(meets, start_m), meets);
    lost |= active & ~bits_of(settled);
    rescue(first, lost);
    if constexpr (kBent) walk_.keep_pieces(r, first);
    return cross<true>(r, corners, active & ~lost, first);
  }

  VEC_INLINE std::uint32_t step(std::size_t first, std::uint32_t lanes) {
    Registers r = walk_.at(first);
    park(r, lanes);
    return cross<false>(r, walk_.grid().corners(r), lanes, first);
  }

  // One cell of rays first, first + 1, ...; returns the lanes that go on. Without branches on what
  // they meet: which lanes are settled can't be foreseen. In the first cells the set's order is
  // that of EyeRays.
  template <bool kFirst>
  VEC_INLINE std::uint32_t cross(Registers& r, const Corners& corners, std::uint32_t active,
                                 std::size_t first) {
    const NextCrossing next = walk_.grid().next_crossing(r, corners);
    const V in = r.slope * r.g - r.z;
    const V out = r.slope * next.g - next.z;
    const std::uint32_t ground = bits_of(next.has_ground) & active;
    const std::uint32_t cut = bits_of(next.g > r.end) & active;
    // Also those whose last piece ends: the grid does before, but for rounding.
    const std::uint32_t ended = cut & bits_of(r.end >= of(front_.terrain().reach_m()));
    std::uint32_t lost = (bits_of(in < of(0)) & ground & ~cut) | ended;
    const std::uint32_t hit = bits_of(hn::And(out <= of(0), next.g > r.g)) & ground & ~(lost | cut);
    tests_ += __builtin_popcount(ground & ~cut);
    const V share = hn::IfThenElseZero(in > of(0), in / (in - out));
    const Registers met = between(r, next, share);
    if constexpr (kFirst) {
      record_in_order(met, hit, first);
    } else {
      record(met, hit, first);
    }
    active &= ~(hit | lost);
    const Registers here = r;
    advance(r, next);
    if constexpr (kBent) walk_.choose(r, mask_of(cut), here);
    const std::uint32_t outside = ~bits_of(walk_.grid().is_inside(r)) & active;
    active &= ~outside;
    walk_.keep(r, first);
    if constexpr (kBent) {
      lost |= outside & walk_.returning(first, outside);
      for (std::uint32_t left = cut & active; left != 0; left &= left - 1)
        walk_.next_piece(first + static_cast<std::size_t>(__builtin_ctz(left)));
    }
    rescue(first, lost);
    return active;
  }

  VEC_INLINE void record_in_order(const Registers& met, std::uint32_t hit, std::size_t first) {
    const M mask = mask_of(hit);
    hn::BlendedStore(met.g, mask, D(), rays_.ground_m.data() + first);
    hn::BlendedStore(met.u, mask, D(), rays_.u.data() + first);
    hn::BlendedStore(met.v, mask, D(), rays_.v.data() + first);
    hn::BlendedStore(met.column, mask, D(), rays_.column.data() + first);
    hn::BlendedStore(met.row, mask, D(), rays_.row.data() + first);
  }

  VEC_INLINE void record(const Registers& met, std::uint32_t hit, std::size_t first) {
    alignas(64) std::array<double, kVectorLanes> lanes[5];
    hn::Store(met.g, D(), lanes[0].data());
    hn::Store(met.u, D(), lanes[1].data());
    hn::Store(met.v, D(), lanes[2].data());
    hn::Store(met.column, D(), lanes[3].data());
    hn::Store(met.row, D(), lanes[4].data());
    for (; hit != 0; hit &= hit - 1) {
      const auto lane = static_cast<std::size_t>(__builtin_ctz(hit));
      const auto i = static_cast<std::size_t>(set_.index[first + lane]);
      rays_.ground_m[i] = lanes[0][lane];
      rays_.u[i] = lanes[1][lane];
      rays_.v[i] = lanes[2][lane];
      rays_.column[i] = lanes[3][lane];
      rays_.row[i] = lanes[4][lane];
    }
  }

  // Takes rays over the sectors that they clear; those that clear all there are have missed.
  VEC_INLINE std::uint32_t look_ahead(std::size_t first, std::uint32_t lanes) {
    Registers r = walk_.at(first);
    // Past the last ray lie those of before.
    const M held = mask_of(lanes);
    const V g = hn::IfThenElseZero(held, r.g);
    const Ints place = hn::DemoteTo(IntTag(), hn::IfThenElseZero(held, load(set_.start, first)));
    const Ints wedge = hn::ShiftRight<EyeFront::kStartBinBits>(place);
    const Ints here = search_.ring_of(hn::DemoteTo(FloatTag(), g));
    const auto there =
        search_.next(here, hn::DemoteTo(FloatTag(), r.slope), wedge, mask_from(FloatTag(), lanes));
    const V start_m = hn::PromoteTo(D(), there.start_m);
    std::uint32_t active = lanes & ~mask_bits(FloatTag(), search_.is_none(there.ring));
    // A leap may settle a little before its end, and must go forward all the same.
    const M far = start_m > g + of(kBent ? 2 * front_.step_back_m() : 0);
    const M further = hn::PromoteTo(D(), there.ring) > hn::PromoteTo(D(), here);
    const M leaps = hn::And(hn::And(further, far), mask_of(active));
    if (bits_of(leaps) != 0) {
      const M settled = walk_.settle(r, first, start_m, leaps).settled;
      // A track that rounding puts on either side of a line may settle behind where it was.
      const M onward = hn::And(settled, r.g >= g);
      const std::uint32_t lost = active & bits_of(hn::AndNot(onward, leaps));
      rescue(first, lost);
      active &= ~lost;
      walk_.keep(r, first);
      if constexpr (kBent) walk_.keep_pieces(r, first);
    }
    return active;
  }

  const EyeFront& front_;
  EyeRays& rays_;
  RaySet& set_;
  RescueList& rescues_;
  FrontSearch<hn::Rebind<float, D>> search_;
  SetWalk<kBent> walk_;
  std::int64_t tests_ = 0;
};

}  // namespace HWY_NAMESPACE
}  // namespace terrview
HWY_AFTER_NAMESPACE();

#endif

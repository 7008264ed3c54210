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
    constexpr int kFirstSteps = 2;
    constexpr int kSteps = 4;
    const std::size_t lanes = hn::Lanes(D());
    for (std::size_t i = 0; i < set_.count; i += lanes) place(i);
    for (std::size_t i = 0; i < set_.count; i += lanes) step<true>(i);
    for (int j = 1; j < kFirstSteps; ++j)
      for (std::size_t i = 0; i < set_.count; i += lanes) step<false>(i);
    pack();
    while (set_.count > 0) {
      for (std::size_t i = 0; i < set_.count; i += lanes) look_ahead(i);
      for (int j = 0; j < kSteps; ++j)
        for (std::size_t i = 0; i < set_.count; i += lanes) step<false>(i);
      pack();
    }
    return tests_;
  }

 private:
  HWY_INLINE std::uint8_t& walking(std::size_t first) {
    return set_.walking[first / hn::Lanes(D())];
  }

  HWY_INLINE std::uint32_t lanes_from(std::size_t first) const {
    return (1U << std::min(hn::Lanes(D()), set_.count - first)) - 1;
  }

  HWY_INLINE void rescue(std::size_t first, std::uint32_t lanes) {
    for (; lanes != 0; lanes &= lanes - 1) {
      const auto i = first + static_cast<std::size_t>(__builtin_ctz(lanes));
      rescues_.rays[rescues_.count++] = static_cast<std::int32_t>(set_.index[i]);
    }
  }

  // Finds the first cells of rays first, first + 1, ..., which are those of EyeRays in order.
  HWY_INLINE void place(std::size_t first) {
    save(rays_.ground_m, first, of(-1));
    const V rise = hn::Abs(load(rays_.direction_z, first));
    const V across_x = load(rays_.direction_x, first);
    const V across_y = load(rays_.direction_y, first);
    // As is_vertical(), or nearly: those near it go the sure way. NaN too.
    const M slanted = across_x * across_x + across_y * across_y > of(4e-24) * rise * rise;
    const V start_m = search_.start_m(load(set_.start, first));
    const M meets = start_m < hn::Inf(D());
    const M settled = walk_.settle(first, hn::IfThenElseZero(meets, start_m), meets);
    const std::uint32_t lanes = lanes_from(first);
    const std::uint32_t lost =
        (lanes & ~bits_of(slanted)) | (lanes & bits_of(hn::AndNot(settled, meets)));
    rescue(first, lost);
    walking(first) = static_cast<std::uint8_t>(lanes & bits_of(meets) & ~lost);
  }

  // One crossing of rays first, first + 1, ... Without branches on what they meet: which lanes are
  // settled can't be foreseen. In the first step the set's order is that of EyeRays.
  template <bool kFirst>
  HWY_INLINE void step(std::size_t first) {
    std::uint32_t active = walking(first);
    if (active == 0) return;
    Registers r = walk_.at(first);
    park(r, active);
    const NextCrossing next = walk_.grid().next_crossing(r);
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
    const Registers here = r;
    advance(r, next);
    if constexpr (kBent) walk_.choose(r, mask_of(cut), here);
    const std::uint32_t outside = ~bits_of(walk_.grid().is_inside(r)) & active & ~(hit | lost);
    active &= ~(hit | lost | outside);
    walk_.keep(r, first);
    if constexpr (kBent) {
      lost |= outside & walk_.returning(first, outside);
      for (std::uint32_t left = cut & active; left != 0; left &= left - 1)
        walk_.next_piece(first + static_cast<std::size_t>(__builtin_ctz(left)));
    }
    walking(first) = static_cast<std::uint8_t>(active);
    rescue(first, lost);
  }

  HWY_INLINE Registers between(const Registers& r, const NextCrossing& next, V share) const {
    Registers met = r;
    met.g = r.g + share * (next.g - r.g);
    met.u = r.u + share * (next.u - r.u);
    met.v = r.v + share * (next.v - r.v);
    return met;
  }

  HWY_INLINE void record_in_order(const Registers& met, std::uint32_t hit, std::size_t first) {
    const M mask = mask_of(hit);
    hn::BlendedStore(met.g, mask, D(), rays_.ground_m.data() + first);
    hn::BlendedStore(met.u, mask, D(), rays_.u.data() + first);
    hn::BlendedStore(met.v, mask, D(), rays_.v.data() + first);
    hn::BlendedStore(met.column, mask, D(), rays_.column.data() + first);
    hn::BlendedStore(met.row, mask, D(), rays_.row.data() + first);
  }

  HWY_INLINE void record(const Registers& met, std::uint32_t hit, std::size_t first) {
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

  void move(std::size_t from, std::size_t to) {
    set_.move(from, to);
    if constexpr (kBent) set_.move_piece(from, to);
  }

  // Moves the rays that walk to the front of the set.
  void pack() {
    std::size_t kept = 0;
    for (std::size_t first = 0; first < set_.count; first += hn::Lanes(D()))
      for (std::uint32_t left = walking(first); left != 0; left &= left - 1)
        move(first + static_cast<std::size_t>(__builtin_ctz(left)), kept++);
    set_.count = kept;
    // Lanes past the last ray are computed all the same.
    for (std::size_t i = kept; i % kVectorLanes != 0; ++i) move(kept - 1, i);
    for (std::size_t first = 0; first < kept; first += hn::Lanes(D()))
      walking(first) = static_cast<std::uint8_t>(lanes_from(first));
  }

  // Takes rays over the sectors that they clear; those that clear all there are have missed.
  HWY_INLINE void look_ahead(std::size_t first) {
    const std::uint32_t lanes = lanes_from(first);
    const V g = load(set_.g, first);
    const V slope = load(set_.slope, first);
    const V wedge = hn::Floor(load(set_.start, first) * of(1.0 / EyeFront::kStartBins));
    const V here = ring_of(first);
    const FrontSearch::Place there = search_.next(here, slope, wedge, lanes);
    walking(first) = static_cast<std::uint8_t>(lanes & ~bits_of(search_.is_none(there.ring)));
    // A leap may settle a little before its end, and must go forward all the same.
    const M far = there.start_m > g + of(kBent ? 2 * front_.step_back_m() : 0);
    const M leaps = hn::And(there.ring > here, far);
    if ((bits_of(leaps) & walking(first)) == 0) return;
    const M settled = walk_.settle(first, there.start_m, leaps);
    const std::uint32_t lost = walking(first) & bits_of(hn::AndNot(settled, leaps));
    rescue(first, lost);
    walking(first) = static_cast<std::uint8_t>(walking(first) & ~lost);
  }

  HWY_INLINE V ring_of(std::size_t first) const {
    alignas(64) std::array<double, kVectorLanes> rings;
    for (std::size_t lane = 0; lane < hn::Lanes(D()); ++lane)
      rings[lane] = front_.ring_of(set_.g[first + lane]);
    return hn::Load(D(), rings.data());
  }

  const EyeFront& front_;
  EyeRays& rays_;
  RaySet& set_;
  RescueList& rescues_;
  FrontSearch search_;
  SetWalk<kBent> walk_;
  std::int64_t tests_ = 0;
};

}  // namespace HWY_NAMESPACE
}  // namespace terrview
HWY_AFTER_NAMESPACE();

#endif

// The look-up of an EyeFront, for several rays at once. Included once for every instruction set.
#if defined(TERRVIEW_TERRAIN_FRONT_SEARCH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef TERRVIEW_TERRAIN_FRONT_SEARCH_INL_H_
#undef TERRVIEW_TERRAIN_FRONT_SEARCH_INL_H_
#else
#define TERRVIEW_TERRAIN_FRONT_SEARCH_INL_H_
#endif

#include <hwy/highway.h>

#include <cstdint>

#include "terrain/eye_front.h"
#include "terrain/vector_ground-inl.h"

HWY_BEFORE_NAMESPACE();
namespace terrview {
namespace HWY_NAMESPACE {

using Ints = hn::Rebind<std::int32_t, D>;
using Floats = hn::Rebind<float, D>;

class FrontSearch {
 public:
  explicit FrontSearch(const EyeFront& front) : front_(front), rings_(front.rings()) {}

  // Where rays from these places of EyeFront::starts_m() may first meet the ground.
  HWY_INLINE V start_m(V place) const { return floats_at(front_.starts_m(), place); }

  // A ring that a ray may meet the ground in, and how far away: none is rings().
  struct Place {
    V ring;
    V start_m;
  };

  // The first one from ring `here` on, by the bounds of a wedge.
  HWY_INLINE Place next(V here, V slope, V wedge, std::uint32_t lanes) const {
    const V beyond = floats_at(
        front_.bounds_beyond(),
        in_group(wedge, hn::Floor(here * of(1.0 / EyeFront::kStride)), front_.coarse_rings()));
    const V from = hn::IfThenElse(beyond < slope, of(rings_), here);
    const V ring = search(from, slope, wedge, lanes);
    // Below the horizon no ground of the ring is above `bound` times its far end: a ray comes down
    // to that height later than to the ring.
    const V known = hn::Min(ring, of(rings_ - 1));
    const V bound = sector_bound(wedge, known);
    const V down_m =
        hn::IfThenElseZero(bound < of(0), ring_at(known + of(1)) * (hn::Max(bound, slope) / slope));
    return {ring, hn::Max(ring_at(known), down_m) - of(front_.margin_m())};
  }

  // The ring in which a distance lies, or within rounding the one before or after: the bound of a
  // ring holds from EyeFront::margin_m() before it on.
  HWY_INLINE V ring_of(V distance_m) const {
    const std::span<const std::int32_t> rings = front_.ring_at_step();
    const V step = hn::Min(hn::Floor(distance_m * of(1 / front_.step_m())),
                           of(static_cast<double>(rings.size() - 1)));
    const V ring =
        hn::PromoteTo(D(), hn::GatherIndex(Ints(), rings.data(), hn::DemoteTo(Ints(), step)));
    // No ring is narrower than a step.
    const V next = hn::Min(ring + of(1), of(rings_ - 1));
    return hn::IfThenElse(ring_at(next) <= distance_m, next, ring);
  }

  HWY_INLINE M is_none(V ring) const { return ring >= of(rings_); }

 private:
  HWY_INLINE V ring_at(V ring) const {
    const hn::Rebind<std::int64_t, D> longs;
    return hn::GatherIndex(D(), front_.ring_m().data(), hn::ConvertTo(longs, ring));
  }

  HWY_INLINE V floats_at(const float* values, V index) const {
    return hn::PromoteTo(D(), hn::GatherIndex(Floats(), values, hn::DemoteTo(Ints(), index)));
  }

  // The bound of a ring in a wedge; infinite past the last ring.
  HWY_INLINE V sector_bound(V wedge, V ring) const {
    return floats_at(front_.bounds(), in_group(wedge, ring, rings_ + 1));
  }

  HWY_INLINE V in_group(V wedge, V ring, int rings) const {
    constexpr int kGroup = EyeFront::kGroup;
    const V group = hn::Floor(wedge * of(1.0 / kGroup));
    return (group * of(rings) + ring) * of(kGroup) + (wedge - group * of(kGroup));
  }

  // The first ring from `ring` on whose bound reaches the slope.
  HWY_INLINE V search(V ring, V slope, V wedge, std::uint32_t lanes) const {
    constexpr int kStride = EyeFront::kStride;
    while (true) {
      const M below = sector_bound(wedge, ring) < slope;
      if ((bits_of(below) & lanes) == 0) return ring;
      const V block = hn::Floor(ring * of(1.0 / kStride));
      const V coarse =
          floats_at(front_.coarse_bounds(), in_group(wedge, block, front_.coarse_rings()));
      const M leap = hn::And(block * of(kStride) == ring, coarse < slope);
      ring = ring + hn::IfThenElseZero(below, hn::IfThenElse(leap, of(kStride), of(1)));
    }
  }

  const EyeFront& front_;
  int rings_;
};

}  // namespace HWY_NAMESPACE
}  // namespace terrview
HWY_AFTER_NAMESPACE();

#endif

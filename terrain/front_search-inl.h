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
#include "terrain/vec_inline.h"
#include "terrain/vector_masks-inl.h"

HWY_BEFORE_NAMESPACE();
namespace terrview {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Floats are the tag F's. Slopes and distances may be off by 2^-22 of themselves: a search looks
// that much further down and begins that much earlier.
template <class F>
class FrontSearch {
 public:
  using I = hn::RebindToSigned<F>;
  using VF = hn::Vec<F>;
  using VI = hn::Vec<I>;
  using MF = hn::Mask<F>;

  explicit FrontSearch(const EyeFront& front) : front_(front), rings_(front.rings()) {}

  // Where rays from these places of EyeFront::starts_m() may first meet the ground.
  VEC_INLINE VF start_m(VI place) const { return hn::GatherIndex(F(), front_.starts_m(), place); }

  // A ring that a ray may meet the ground in, and how far away: none is rings().
  struct Place {
    VI ring;
    VF start_m;
  };

  // The first one from ring `here` on, by the bounds of a wedge.
  VEC_INLINE Place next(VI here, VF ray_slope, VI wedge, MF lanes) const {
    const VF slope = ray_slope - hn::Abs(ray_slope) * of(kRounding);
    const VI block = hn::ShiftRight<kStrideBits>(here);
    const VF beyond =
        hn::GatherIndex(F(), front_.bounds_beyond(), in_group(wedge, block, front_.coarse_rings()));
    const VI from = hn::IfThenElse(hn::RebindMask(I(), beyond < slope), hn::Set(I(), rings_), here);
    const VI ring = search(from, slope, wedge, lanes);
    // Below the horizon no ground of the ring is above `bound` times its far end: a ray comes down
    // to that height later than to the ring.
    const VI known = hn::Min(ring, hn::Set(I(), rings_ - 1));
    const VF bound = sector_bound(wedge, known);
    const VF down_m = hn::IfThenElseZero(
        bound < of(0), ring_at(known + hn::Set(I(), 1)) * (hn::Max(bound, slope) / slope));
    const VF start_m = hn::Max(ring_at(known), down_m) * of(1 - kRounding);
    return {ring, start_m - of(static_cast<float>(front_.margin_m()))};
  }

  // The ring in which a distance lies, or within rounding the one before.
  VEC_INLINE VI ring_of(VF distance_m) const {
    const std::span<const std::int32_t> rings = front_.ring_at_step();
    const VF at_m = distance_m * of(1 - kRounding);
    const VF step = hn::Min(at_m * of(static_cast<float>(1 / front_.step_m())) * of(1 - kRounding),
                            of(static_cast<float>(rings.size() - 1)));
    const VI known = hn::Min(hn::ConvertTo(I(), step),
                             hn::Set(I(), static_cast<std::int32_t>(rings.size()) - 1));
    const VI ring = hn::GatherIndex(I(), rings.data(), hn::Max(known, hn::Zero(I())));
    // No ring is narrower than a step.
    const VI next = hn::Min(ring + hn::Set(I(), 1), hn::Set(I(), rings_ - 1));
    return hn::IfThenElse(hn::RebindMask(I(), ring_at(next) <= at_m), next, ring);
  }

  VEC_INLINE MF is_none(VI ring) const {
    return hn::RebindMask(F(), ring > hn::Set(I(), rings_ - 1));
  }

 private:
  static constexpr float kRounding = 0x1p-21F;
  static constexpr int kStrideBits = EyeFront::kStrideBits;
  static constexpr int kGroupBits = EyeFront::kGroupBits;

  static VEC_INLINE VF of(float x) { return hn::Set(F(), x); }

  VEC_INLINE VF ring_at(VI ring) const {
    return hn::GatherIndex(F(), front_.near_m().data(), ring);
  }

  // The bound of a ring in a wedge; infinite past the last ring.
  VEC_INLINE VF sector_bound(VI wedge, VI ring) const {
    return hn::GatherIndex(F(), front_.bounds(), in_group(wedge, ring, rings_ + 1));
  }

  VEC_INLINE VI in_group(VI wedge, VI ring, int rings) const {
    const VI group = hn::ShiftRight<kGroupBits>(wedge);
    const VI in_group = hn::And(wedge, hn::Set(I(), EyeFront::kGroup - 1));
    return hn::ShiftLeft<kGroupBits>(group * hn::Set(I(), rings) + ring) + in_group;
  }

  // The first ring from `ring` on whose bound reaches the slope.
  VEC_INLINE VI search(VI ring, VF slope, VI wedge, MF lanes) const {
    const VI one = hn::Set(I(), 1);
    const VI stride = hn::Set(I(), EyeFront::kStride);
    while (true) {
      const MF below = sector_bound(wedge, ring) < slope;
      if (hn::AllFalse(F(), hn::And(below, lanes))) return ring;
      const VI block = hn::ShiftRight<kStrideBits>(ring);
      const VF coarse = hn::GatherIndex(F(), front_.coarse_bounds(),
                                        in_group(wedge, block, front_.coarse_rings()));
      const auto leap =
          hn::And(hn::ShiftLeft<kStrideBits>(block) == ring, hn::RebindMask(I(), coarse < slope));
      ring =
          ring + hn::IfThenElseZero(hn::RebindMask(I(), below), hn::IfThenElse(leap, stride, one));
    }
  }

  const EyeFront& front_;
  int rings_;
};

}  // namespace HWY_NAMESPACE
}  // namespace terrview
HWY_AFTER_NAMESPACE();

#endif

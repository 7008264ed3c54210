// How steeply ground at a distance is seen from the eye, and bounds of it: vectors of single
// precision. Included once for every instruction set.
#if defined(TERRVIEW_TERRAIN_SIGHT_SLOPES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef TERRVIEW_TERRAIN_SIGHT_SLOPES_INL_H_
#undef TERRVIEW_TERRAIN_SIGHT_SLOPES_INL_H_
#else
#define TERRVIEW_TERRAIN_SIGHT_SLOPES_INL_H_
#endif

#include <hwy/highway.h>

#include <cmath>

#include "terrain/sight_edges.h"
#include "terrain/terrain.h"
#include "terrain/vec_inline.h"
#include "terrain/vertical_math.h"

HWY_BEFORE_NAMESPACE();
namespace terrview {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using F = hn::CappedTag<float, SightEdges::kVector>;
using I = hn::RebindToSigned<F>;
using VF = hn::Vec<F>;
using VI = hn::Vec<I>;
using MF = hn::Mask<F>;

VEC_INLINE VF of(float x) { return hn::Set(F(), x); }
VEC_INLINE VI whole(VF x) { return hn::ConvertTo(I(), x); }

// Bounds from both sides.
struct Bounds {
  VF low, high;
};

// What a distance makes of heights: slope = drop + scale * lift.
struct Slopes {
  VF drop, scale;
};

class SightSlopes {
 public:
  SightSlopes(const Terrain& terrain, double observer_m)
      : z_scale_(static_cast<float>(terrain.frame().z_scale)),
        eye_height_m_(static_cast<float>(terrain.frame().eye_height_m)),
        half_refraction_(static_cast<float>(terrain.frame().refraction / 2)),
        height_slack_m_(kRounding * static_cast<float>(terrain.height_bound_m() + observer_m +
                                                       std::abs(terrain.frame().eye_height_m))) {}

  // By the series of terrain/vertical_math.h, as far as single precision goes.
  VEC_INLINE Slopes at(VF away, VF curvature) const {
    const VF gamma = away * curvature;
    const VF gamma2 = gamma * gamma;
    const VF half_tangent = of(static_cast<float>(kHalfTangent[0])) +
                            gamma2 * (of(static_cast<float>(kHalfTangent[1])) +
                                      gamma2 * of(static_cast<float>(kHalfTangent[2])));
    const VF stretch = of(static_cast<float>(kInverseSinc[0])) +
                       gamma2 * (of(static_cast<float>(kInverseSinc[1])) +
                                 gamma2 * of(static_cast<float>(kInverseSinc[2])));
    return {gamma * (of(half_refraction_) - half_tangent), stretch / away};
  }

  // (h - eye) / (1 + curvature h), h so far above a height of the grid.
  VEC_INLINE VF lift(VF height, VF above, VF curvature) const {
    const VF scene_height = of(z_scale_) * height + above;
    return (scene_height - of(eye_height_m_)) / (of(1) + curvature * scene_height);
  }

  // Above all rounding, and above what a distance that is off by a `share` of itself makes of a
  // slope.
  VEC_INLINE VF slack(const Slopes& at, VF lift, VF share) const {
    const VF drop = hn::Abs(at.drop);
    return share * (drop + at.scale * hn::Abs(lift)) + of(kRounding) * drop +
           at.scale * of(height_slack_m_);
  }

  // Of lifts between two, at distances between two.
  VEC_INLINE Bounds between(const Slopes& a, const Slopes& b, const Bounds& lifts, VF share) const {
    const VF low = hn::Min(a.drop, b.drop) + hn::Min(a.scale * lifts.low, b.scale * lifts.low);
    const VF high = hn::Max(a.drop, b.drop) + hn::Max(a.scale * lifts.high, b.scale * lifts.high);
    const VF doubt = slack({hn::Min(a.drop, b.drop), hn::Max(a.scale, b.scale)},
                           hn::Max(hn::Abs(lifts.low), hn::Abs(lifts.high)), share);
    return {low - doubt, high + doubt};
  }

 private:
  // Of a few sums and products, as a share of them.
  static constexpr float kRounding = 0x1p-19F;

  float z_scale_;
  float eye_height_m_;
  float half_refraction_;
  float height_slack_m_;
};

}  // namespace HWY_NAMESPACE
}  // namespace terrview
HWY_AFTER_NAMESPACE();

#endif

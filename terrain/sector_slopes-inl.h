// How steeply ground of a known height is seen between two distances, for the wedges of an
// EyeFront. Included once for every instruction set.
#if defined(TERRVIEW_TERRAIN_SECTOR_SLOPES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef TERRVIEW_TERRAIN_SECTOR_SLOPES_INL_H_
#undef TERRVIEW_TERRAIN_SECTOR_SLOPES_INL_H_
#else
#define TERRVIEW_TERRAIN_SECTOR_SLOPES_INL_H_
#endif

#include <hwy/highway.h>

#include <cmath>
#include <cstddef>
#include <limits>

#include "terrain/vec_inline.h"
#include "terrain/vector_ground-inl.h"
#include "terrain/wedge_edges.h"

HWY_BEFORE_NAMESPACE();
namespace terrview {
namespace HWY_NAMESPACE {

class SectorSlopes {
 public:
  SectorSlopes(const VerticalFrame& frame, const WedgeEdges& edges)
      : frame_(frame),
        flat_(frame.is_flat()),
        eye_height_m_(frame.eye_height_m),
        z_scale_(frame.z_scale),
        edges_(edges) {}

  // No z / s of ground up to `height` is above these, from `near_m` to `far_m` in wedges `first`,
  // ...; -infinity where the height is that.
  VEC_INLINE V highest(std::size_t first, V near_m, V far_m, V height) const {
    const V z = ceiling(first, near_m, far_m, height);
    const V slack =
        of(kRounding) * (hn::Abs(of(z_scale_) * height) + of(std::abs(eye_height_m_)) + hn::Abs(z));
    const V top = z + slack;
    // Infinite right below the eye, or NaN.
    const V slope = top / hn::IfThenElse(top < of(0), far_m, near_m);
    const V bound = hn::IfThenElse(hn::Or(top<of(0), near_m> of(0)), slope, hn::Inf(D()));
    // Above the rounding to a float.
    const V rounded_up = bound + hn::Abs(bound) * of(0x1p-22) + of(1e-30);
    const V none = of(-std::numeric_limits<double>::infinity());
    return hn::IfThenElse(height == none, none, rounded_up);
  }

 private:
  // Larger than the rounding of a clearance, as a share of the numbers it comes from.
  static constexpr double kRounding = 1e-11;

  // The highest z. Along an edge of a wedge z is monotonic in the distance, or bends by less than
  // the slack; and in the azimuth, because no wedge crosses an axis.
  VEC_INLINE V ceiling(std::size_t first, V near_m, V far_m, V height) const {
    if (flat_) return of(z_scale_) * height - of(eye_height_m_);
    const V x_a = hn::Load(D(), edges_.x_a.data() + first);
    const V y_a = hn::Load(D(), edges_.y_a.data() + first);
    const V x_b = hn::Load(D(), edges_.x_b.data() + first);
    const V y_b = hn::Load(D(), edges_.y_b.data() + first);
    const auto at = [&](V s) HWY_ATTR {
      return hn::Max(frame_.z(x_a * s, y_a * s, height), frame_.z(x_b * s, y_b * s, height));
    };
    return hn::Max(at(near_m), at(far_m));
  }

  VectorFrame frame_;
  bool flat_;
  double eye_height_m_;
  double z_scale_;
  const WedgeEdges& edges_;
};

}  // namespace HWY_NAMESPACE
}  // namespace terrview
HWY_AFTER_NAMESPACE();

#endif

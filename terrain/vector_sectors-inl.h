// The sectors of terrain/square_sectors.h, for several directions at once. Included once for every
// instruction set.
#if defined(TERRVIEW_TERRAIN_VECTOR_SECTORS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef TERRVIEW_TERRAIN_VECTOR_SECTORS_INL_H_
#undef TERRVIEW_TERRAIN_VECTOR_SECTORS_INL_H_
#else
#define TERRVIEW_TERRAIN_VECTOR_SECTORS_INL_H_
#endif

#include <hwy/highway.h>

#include "terrain/vec_inline.h"

HWY_BEFORE_NAMESPACE();
namespace terrview {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Those of unit directions, as sector_of() finds them; in floats, but for rounding. A vertical
// ray's NaN becomes sector 0.
template <class Tag>
VEC_INLINE hn::Vec<Tag> sectors_of(Tag d, hn::Vec<Tag> x, hn::Vec<Tag> y, int a_side) {
  using Value = hn::TFromD<Tag>;
  const auto of = [d](auto value) HWY_ATTR { return hn::Set(d, static_cast<Value>(value)); };
  const auto far_x = hn::Abs(x);
  const auto far_y = hn::Abs(y);
  const auto along_y = far_y >= far_x;
  const auto c = hn::IfThenElse(along_y, x, y) / hn::Max(far_x, far_y);
  const auto side = hn::IfThenElse(along_y, hn::IfThenElse(y > of(0), of(0), of(2 * a_side)),
                                   hn::IfThenElse(x > of(0), of(a_side), of(3 * a_side)));
  const auto place = hn::Floor((c + of(1)) * of(0.5 * a_side));
  const auto sector = side + hn::Min(place, of(a_side - 1));
  return hn::IfThenElseZero(place >= of(0), sector);
}

}  // namespace HWY_NAMESPACE
}  // namespace terrview
HWY_AFTER_NAMESPACE();

#endif

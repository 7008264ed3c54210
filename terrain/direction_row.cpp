#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "terrain/direction_row.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for every instruction set
//
#include <hwy/highway.h>

#include <cstddef>

#include "terrain/direction_row.h"

HWY_BEFORE_NAMESPACE();
namespace terrview {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

void lay_axis(const DirectionRow& row, int axis, std::span<double> values) {
  const double first = row.first[axis];
  const double right = row.right[axis];
  const double above = row.above[axis];
  const hn::ScalableTag<double> d;
  const auto of = [d](double x) HWY_ATTR { return hn::Set(d, x); };
  const std::size_t lanes = hn::Lanes(d);
  const auto steps = hn::Iota(d, 0);
  std::size_t i = 0;
  for (; i + lanes <= values.size(); i += lanes) {
    const auto at = (of(row.from) + (of(static_cast<double>(i)) + steps)) - of(row.middle);
    hn::StoreU((of(first) + of(right) * (at * of(row.step))) + of(above), d, values.data() + i);
  }
  for (; i < values.size(); ++i) {
    const double at = row.from + static_cast<double>(i) - row.middle;
    values[i] = (first + right * (at * row.step)) + above;
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace terrview
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace terrview {

HWY_EXPORT(lay_axis);

void lay(const DirectionRow& row, const DirectionSpans& directions) {
  HWY_DYNAMIC_DISPATCH(lay_axis)(row, 0, directions.x);
  HWY_DYNAMIC_DISPATCH(lay_axis)(row, 1, directions.y);
  HWY_DYNAMIC_DISPATCH(lay_axis)(row, 2, directions.z);
}

}  // namespace terrview
#endif

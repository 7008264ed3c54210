// The pieces of EyeTracks that several rays go along. Included once for every instruction set.
#if defined(TERRVIEW_TERRAIN_VECTOR_TRACKS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef TERRVIEW_TERRAIN_VECTOR_TRACKS_INL_H_
#undef TERRVIEW_TERRAIN_VECTOR_TRACKS_INL_H_
#else
#define TERRVIEW_TERRAIN_VECTOR_TRACKS_INL_H_
#endif

#include <hwy/highway.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "terrain/vec_inline.h"
#include "terrain/vector_masks-inl.h"

HWY_BEFORE_NAMESPACE();
namespace terrview {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// The numbers of the pieces that distances lie on.
template <class Tag>
VEC_INLINE hn::Vec<Tag> pieces_at(Tag d, const std::vector<double>& knots_m, hn::Vec<Tag> g) {
  hn::Vec<Tag> piece = hn::Zero(d);
  for (std::size_t i = 1; i + 1 < knots_m.size(); ++i) {
    const auto beyond = g >= hn::Set(d, static_cast<hn::TFromD<Tag>>(knots_m[i]));
    if (hn::AllFalse(d, beyond)) break;
    piece = piece + hn::IfThenElseZero(beyond, hn::Set(d, 1));
  }
  return piece;
}

// The kCount values of a table from stride * row[i] on, by lane; other lanes than `lanes` get those
// of one that is. Neighbouring rays share rows: to load each row once takes less than gathers.
template <std::size_t kCount, class Tag>
VEC_INLINE std::array<hn::Vec<Tag>, kCount> shared_rows(Tag d, const hn::TFromD<Tag>* table,
                                                        std::size_t stride,
                                                        hn::Vec<hn::Rebind<std::int32_t, Tag>> row,
                                                        std::uint32_t lanes) {
  const hn::Rebind<std::int32_t, Tag> ints;
  alignas(64) std::array<std::int32_t, hn::MaxLanes(d)> rows;
  hn::Store(row, ints, rows.data());
  std::array<hn::Vec<Tag>, kCount> values;
  values.fill(hn::Zero(d));
  bool is_first = true;
  for (std::uint32_t left = lanes; left != 0; is_first = false) {
    const std::int32_t next = rows[static_cast<std::size_t>(__builtin_ctz(left))];
    const std::uint32_t here = mask_bits(ints, row == hn::Set(ints, next));
    const hn::TFromD<Tag>* from = table + static_cast<std::size_t>(next) * stride;
    if (is_first) {
      for (std::size_t i = 0; i < kCount; ++i) values[i] = hn::Set(d, from[i]);
    } else {
      const auto taken = mask_from(d, here);
      for (std::size_t i = 0; i < kCount; ++i)
        values[i] = hn::IfThenElse(taken, hn::Set(d, from[i]), values[i]);
    }
    left &= ~here;
  }
  return values;
}

}  // namespace HWY_NAMESPACE
}  // namespace terrview
HWY_AFTER_NAMESPACE();

#endif

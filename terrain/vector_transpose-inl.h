// Rows to columns. Included once for every instruction set.
#if defined(TERRVIEW_TERRAIN_VECTOR_TRANSPOSE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef TERRVIEW_TERRAIN_VECTOR_TRANSPOSE_INL_H_
#undef TERRVIEW_TERRAIN_VECTOR_TRANSPOSE_INL_H_
#else
#define TERRVIEW_TERRAIN_VECTOR_TRANSPOSE_INL_H_
#endif

#include <hwy/highway.h>
#include "terrain/vec_inline.h"

#include <array>
#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace terrview {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// to[i][k] = from[k][i], for i and k below 4.
template <class T>
VEC_INLINE void transpose_4x4(const std::array<const T*, 4>& from, const std::array<T*, 4>& to) {
#if HWY_TARGET == HWY_SCALAR
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < 4; ++k) to[i][k] = from[k][i];
#else
  const hn::FixedTag<T, 4> d;
  const auto even = hn::LoadU(d, from[0]);
  const auto odd = hn::LoadU(d, from[1]);
  const auto even2 = hn::LoadU(d, from[2]);
  const auto odd2 = hn::LoadU(d, from[3]);
  const auto low_even = hn::InterleaveLower(d, even, even2);
  const auto low_odd = hn::InterleaveLower(d, odd, odd2);
  const auto high_even = hn::InterleaveUpper(d, even, even2);
  const auto high_odd = hn::InterleaveUpper(d, odd, odd2);
  hn::StoreU(hn::InterleaveLower(d, low_even, low_odd), d, to[0]);
  hn::StoreU(hn::InterleaveUpper(d, low_even, low_odd), d, to[1]);
  hn::StoreU(hn::InterleaveLower(d, high_even, high_odd), d, to[2]);
  hn::StoreU(hn::InterleaveUpper(d, high_even, high_odd), d, to[3]);
#endif
}

}  // namespace HWY_NAMESPACE
}  // namespace terrview
HWY_AFTER_NAMESPACE();

#endif

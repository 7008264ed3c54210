// Masks of vectors as bits, lane i as bit i. Included once for every instruction set.
#if defined(TERRVIEW_TERRAIN_VECTOR_MASKS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef TERRVIEW_TERRAIN_VECTOR_MASKS_INL_H_
#undef TERRVIEW_TERRAIN_VECTOR_MASKS_INL_H_
#else
#define TERRVIEW_TERRAIN_VECTOR_MASKS_INL_H_
#endif

#include <hwy/highway.h>

#include <cstdint>

#include "terrain/vec_inline.h"

HWY_BEFORE_NAMESPACE();
namespace terrview {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Of up to 16 lanes.
template <class Tag>
VEC_INLINE std::uint32_t mask_bits(Tag d, hn::Mask<Tag> mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(d, mask, bytes);
  return bytes[0] | static_cast<std::uint32_t>(bytes[1]) << 8;
}

template <class Tag>
VEC_INLINE hn::Mask<Tag> mask_from(Tag d, std::uint32_t bits) {
  const std::uint8_t bytes[8] = {static_cast<std::uint8_t>(bits),
                                 static_cast<std::uint8_t>(bits >> 8)};
  return hn::LoadMaskBits(d, bytes);
}

}  // namespace HWY_NAMESPACE
}  // namespace terrview
HWY_AFTER_NAMESPACE();

#endif

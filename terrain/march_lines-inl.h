// Vectors of the lines of rays that are to march. Included once for every instruction set.
#if defined(TERRVIEW_TERRAIN_MARCH_LINES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef TERRVIEW_TERRAIN_MARCH_LINES_INL_H_
#undef TERRVIEW_TERRAIN_MARCH_LINES_INL_H_
#else
#define TERRVIEW_TERRAIN_MARCH_LINES_INL_H_
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

#include "terrain/march_lines.h"
#include "terrain/vec_inline.h"
#include "terrain/vector_ground-inl.h"

HWY_BEFORE_NAMESPACE();
namespace terrview {
namespace HWY_NAMESPACE {

// Eight lines at a time, from `first` on.
class LineLanes {
 protected:
  explicit LineLanes(MarchLines& lines) : lines_(lines) {}

  VEC_INLINE V get(const MarchLines::Doubles& values, std::size_t first) const {
    return hn::Load(D(), values.data() + first);
  }
  VEC_INLINE void keep(MarchLines::Doubles& values, std::size_t first, V value) const {
    hn::Store(value, D(), values.data() + first);
  }
  VEC_INLINE std::uint32_t lanes_from(std::size_t first) const {
    return lanes_below(lines_.count, first);
  }

  VEC_INLINE void mark(std::size_t first, std::uint32_t lanes, March fate, Fates& fates) const {
    for (; lanes != 0; lanes &= lanes - 1)
      fates[static_cast<std::size_t>(
          lines_.index[first + static_cast<std::size_t>(__builtin_ctz(lanes))])] = fate;
  }

  MarchLines& lines_;
};

}  // namespace HWY_NAMESPACE
}  // namespace terrview
HWY_AFTER_NAMESPACE();

#endif

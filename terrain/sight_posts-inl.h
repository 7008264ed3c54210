// The posts of a grid along the lines that a SightSweep crosses: vectors of single precision.
// Included once for every instruction set.
#if defined(TERRVIEW_TERRAIN_SIGHT_POSTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef TERRVIEW_TERRAIN_SIGHT_POSTS_INL_H_
#undef TERRVIEW_TERRAIN_SIGHT_POSTS_INL_H_
#else
#define TERRVIEW_TERRAIN_SIGHT_POSTS_INL_H_
#endif

#include <hwy/highway.h>

#include "terrain/height_grid.h"
#include "terrain/sight_edges.h"
#include "terrain/sight_slopes-inl.h"
#include "terrain/vec_inline.h"

HWY_BEFORE_NAMESPACE();
namespace terrview {
namespace HWY_NAMESPACE {

// Three posts in a row on a line, the first of them in this row. Rows count from the side's base.
struct Posts {
  VF row, first, second, third;

  // Whether all have heights, as far as lanes tell.
  [[nodiscard]] VEC_INLINE MF are_known() const {
    const VF sum = first + second + third;
    return sum == sum;
  }

  // NaN counts for nothing.
  [[nodiscard]] VEC_INLINE VF highest() const {
    return hn::Max(known(first), hn::Max(known(second), known(third)));
  }

  // Of the ground between two places on the line, from the first post on. `second_within`: whether
  // the second post lies before `high`.
  [[nodiscard]] VEC_INLINE Bounds between(VF low, VF high, MF second_within) const {
    const VF rise = second - first;
    const VF past = high - row - of(1);
    const VF at_low = first + (low - row) * rise;
    const VF at_high = second + past * hn::IfThenElse(second_within, third - second, rise);
    const VF least = hn::Min(at_low, at_high);
    const VF most = hn::Max(at_low, at_high);
    return {hn::IfThenElse(second_within, hn::Min(least, second), least),
            hn::IfThenElse(second_within, hn::Max(most, second), most)};
  }

 private:
  static VEC_INLINE VF known(VF height) {
    constexpr float kDeep_m = 1e5F;  // below all ground
    return hn::IfThenElse(height == height, height, of(-kDeep_m));
  }
};

class SightPosts {
 public:
  SightPosts(const HeightGrid& grid, const SightSide& side)
      : heights_m_(grid.heights_m.data()),
        across_stride_(side.axis == 0 ? grid.columns : 1),
        line_stride_(side.axis == 0 ? 1 : grid.columns),
        base_(side.base),
        first_row_(static_cast<float>(-side.base)),
        last_row_(static_cast<float>(side.rows - 1 - side.base)) {}

  [[nodiscard]] VF first_row() const { return of(first_row_); }
  [[nodiscard]] VF last_row() const { return of(last_row_); }

  // The index of a post in the grid.
  [[nodiscard]] std::size_t index(int row, int line) const {
    return static_cast<std::size_t>((row + base_) * across_stride_ + line * line_stride_);
  }

  // Beyond the grid's edge a row is taken for the last.
  [[nodiscard]] VEC_INLINE VF heights(VF row, int line) const {
    const VF known = hn::Min(hn::Max(row, first_row()), last_row());
    const VI index = (whole(known) + hn::Set(I(), base_)) * hn::Set(I(), across_stride_) +
                     hn::Set(I(), line * line_stride_);
    return hn::GatherIndex(F(), heights_m_, index);
  }

  [[nodiscard]] VEC_INLINE Posts from(VF row, int line) const {
    return {row, heights(row, line), heights(row + of(1), line), heights(row + of(2), line)};
  }

  // The heights of a row where `met`, most often those of one of `posts` on the line.
  [[nodiscard]] VEC_INLINE VF heights_in(const Posts& posts, VF row, MF met, int line) const {
    const VF past = row - posts.row;
    const MF beside = hn::Or(past<of(0), past> of(2));
    if (!hn::AllFalse(F(), hn::And(met, beside))) return heights(row, line);
    return hn::IfThenElse(past < of(1), posts.first,
                          hn::IfThenElse(past < of(2), posts.second, posts.third));
  }

 private:
  const float* heights_m_;
  int across_stride_;
  int line_stride_;
  int base_;
  float first_row_;
  float last_row_;
};

}  // namespace HWY_NAMESPACE
}  // namespace terrview
HWY_AFTER_NAMESPACE();

#endif

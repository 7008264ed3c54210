#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "terrain/height_ceilings.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for every instruction set
//
#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

#include "terrain/height_ceilings.h"
#include "terrain/vec_inline.h"

HWY_BEFORE_NAMESPACE();
namespace terrview {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// The higher of two heights; NaN counts as none.
VEC_INLINE float higher(float a, float b) { return b > a ? b : a; }

// out[i] = the highest of column i of `rows` rows. `out` starts at -infinity.
void highest_of_rows(const float* posts, std::size_t columns, std::size_t rows, float* out) {
  const hn::ScalableTag<float> d;
  const std::size_t lanes = hn::Lanes(d);
  std::size_t i = 0;
  for (; i + lanes <= columns; i += lanes) {
    auto highest = hn::Set(d, -std::numeric_limits<float>::infinity());
    for (std::size_t row = 0; row < rows; ++row) {
      const auto post = hn::LoadU(d, posts + row * columns + i);
      highest = hn::IfThenElse(post > highest, post, highest);
    }
    hn::StoreU(highest, d, out + i);
  }
  for (; i < columns; ++i) {
    out[i] = -std::numeric_limits<float>::infinity();
    for (std::size_t row = 0; row < rows; ++row) out[i] = higher(out[i], posts[row * columns + i]);
  }
}

// out[i] = the highest of in[2 i], in[2 i + 1] and, with kShared, in[2 i + 2], of `count` values.
template <bool kShared>
void highest_of_pairs(const float* in, std::size_t count, float* out, std::size_t blocks) {
  const hn::ScalableTag<float> d;
  const std::size_t lanes = hn::Lanes(d);
  std::size_t i = 0;
  for (; 2 * (i + lanes) + 2 <= count; i += lanes) {
    hn::Vec<decltype(d)> even;
    hn::Vec<decltype(d)> odd;
    hn::LoadInterleaved2(d, in + 2 * i, even, odd);
    auto highest = hn::Max(even, odd);
    if (kShared) {
      hn::Vec<decltype(d)> next;
      hn::Vec<decltype(d)> unused;
      hn::LoadInterleaved2(d, in + 2 * i + 2, next, unused);
      highest = hn::Max(highest, next);
    }
    hn::StoreU(highest, d, out + i);
  }
  for (; i < blocks; ++i) {
    out[i] = in[2 * i];
    for (std::size_t j = 2 * i + 1; j < std::min(2 * i + (kShared ? 3 : 2), count); ++j)
      out[i] = higher(out[i], in[j]);
  }
}

void highest_of_post_pairs(const float* in, std::size_t count, float* out, std::size_t blocks) {
  highest_of_pairs<true>(in, count, out, blocks);
}
void highest_of_block_pairs(const float* in, std::size_t count, float* out, std::size_t blocks) {
  highest_of_pairs<false>(in, count, out, blocks);
}

}  // namespace HWY_NAMESPACE
}  // namespace terrview
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace terrview {

HWY_EXPORT(highest_of_rows);
HWY_EXPORT(highest_of_post_pairs);
HWY_EXPORT(highest_of_block_pairs);

namespace {

constexpr int kRowsATime = 32;

// What a level is made from: posts, whose blocks share their borders, or the blocks of the level
// below.
struct Source {
  const float* values;
  int columns;
  int rows;
  int border;
};

void fill_rows(const Source& from, HeightCeilings::Level& level, int first_row) {
  const auto columns = static_cast<std::size_t>(from.columns);
  const auto blocks = static_cast<std::size_t>(level.columns);
  std::vector<float> highest(columns);
  for (int row = first_row; row < std::min(first_row + kRowsATime, level.rows); ++row) {
    const int first = 2 * row;
    const auto rows = static_cast<std::size_t>(std::min(2 + from.border, from.rows - first));
    HWY_DYNAMIC_DISPATCH(highest_of_rows)
    (from.values + static_cast<std::size_t>(first) * columns, columns, rows, highest.data());
    float* out = level.highest_m.get() + static_cast<std::size_t>(row) * blocks;
    if (from.border == 1)
      HWY_DYNAMIC_DISPATCH(highest_of_post_pairs)(highest.data(), columns, out, blocks);
    else
      HWY_DYNAMIC_DISPATCH(highest_of_block_pairs)(highest.data(), columns, out, blocks);
  }
}

HeightCeilings::Level level_of(const Source& from, const ForEach& for_each) {
  HeightCeilings::Level level{(from.columns + 1 - from.border) / 2,
                              (from.rows + 1 - from.border) / 2, nullptr};
  level.highest_m = std::make_unique_for_overwrite<float[]>(level.blocks());
  for_each((level.rows + kRowsATime - 1) / kRowsATime,
           [&](int part) { fill_rows(from, level, part * kRowsATime); });
  return level;
}

}  // namespace

HeightCeilings::HeightCeilings(const HeightGrid& grid, const ForEach& for_each) {
  levels_.push_back(level_of({grid.heights_m.data(), grid.columns, grid.rows, 1}, for_each));
  while (levels_.back().columns > 1 || levels_.back().rows > 1) {
    const Level& fine = levels_.back();
    levels_.push_back(level_of({fine.highest_m.get(), fine.columns, fine.rows, 0}, for_each));
  }
}

std::size_t HeightCeilings::bytes() const {
  std::size_t floats = 0;
  for (const Level& level : levels_) floats += level.blocks();
  return floats * sizeof(float);
}

}  // namespace terrview
#endif

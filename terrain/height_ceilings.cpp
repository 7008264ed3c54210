#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "terrain/height_ceilings.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for every instruction set
//
#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include "terrain/height_ceilings.h"

HWY_BEFORE_NAMESPACE();
namespace terrview {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// The higher of two heights; NaN counts as none.
HWY_INLINE float higher(float a, float b) { return b > a ? b : a; }

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

// out[i] = the highest of in[2 i] ... in[2 i + 2], of `count` values.
void highest_of_pairs(const float* in, std::size_t count, float* out, std::size_t blocks) {
  const hn::ScalableTag<float> d;
  const std::size_t lanes = hn::Lanes(d);
  std::size_t i = 0;
  for (; 2 * (i + lanes) + 2 <= count; i += lanes) {
    hn::Vec<decltype(d)> even;
    hn::Vec<decltype(d)> odd;
    hn::Vec<decltype(d)> next;
    hn::Vec<decltype(d)> unused;
    hn::LoadInterleaved2(d, in + 2 * i, even, odd);
    hn::LoadInterleaved2(d, in + 2 * i + 2, next, unused);
    hn::StoreU(hn::Max(hn::Max(even, odd), next), d, out + i);
  }
  for (; i < blocks; ++i) {
    out[i] = in[2 * i];
    for (std::size_t j = 2 * i + 1; j < std::min(2 * i + 3, count); ++j)
      out[i] = higher(out[i], in[j]);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace terrview
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace terrview {

HWY_EXPORT(highest_of_rows);
HWY_EXPORT(highest_of_pairs);

namespace {

// Level 1, from the posts.
HeightCeilings::Level finest(const HeightGrid& grid) {
  const auto columns = static_cast<std::size_t>(grid.columns);
  const int last_row = grid.rows - 1;
  HeightCeilings::Level level{grid.columns / 2, grid.rows / 2, {}};
  const auto blocks = static_cast<std::size_t>(level.columns);
  level.highest_m.resize(blocks * static_cast<std::size_t>(level.rows));
  std::vector<float> highest(columns);
  for (int row = 0; row < level.rows; ++row) {
    const int first = 2 * row;
    const auto rows = static_cast<std::size_t>(std::min(first + 2, last_row) - first + 1);
    HWY_DYNAMIC_DISPATCH(highest_of_rows)
    (grid.heights_m.data() + static_cast<std::size_t>(first) * columns, columns, rows,
     highest.data());
    HWY_DYNAMIC_DISPATCH(highest_of_pairs)
    (highest.data(), columns, level.highest_m.data() + static_cast<std::size_t>(row) * blocks,
     blocks);
  }
  return level;
}

HeightCeilings::Level coarser(const HeightCeilings::Level& fine) {
  const auto at = [&](int column, int row) {
    return fine.highest_m[static_cast<std::size_t>(row) * static_cast<std::size_t>(fine.columns) +
                          static_cast<std::size_t>(column)];
  };
  HeightCeilings::Level level{(fine.columns + 1) / 2, (fine.rows + 1) / 2, {}};
  level.highest_m.reserve(static_cast<std::size_t>(level.columns) *
                          static_cast<std::size_t>(level.rows));
  for (int row = 0; row < level.rows; ++row) {
    const int north = 2 * row;
    const int south = std::min(north + 1, fine.rows - 1);
    for (int column = 0; column < level.columns; ++column) {
      const int west = 2 * column;
      const int east = std::min(west + 1, fine.columns - 1);
      level.highest_m.push_back(std::max(std::max(at(west, north), at(east, north)),
                                         std::max(at(west, south), at(east, south))));
    }
  }
  return level;
}

}  // namespace

HeightCeilings::HeightCeilings(const HeightGrid& grid) {
  levels_.push_back(finest(grid));
  while (levels_.back().columns > 1 || levels_.back().rows > 1)
    levels_.push_back(coarser(levels_.back()));
}

std::size_t HeightCeilings::bytes() const {
  std::size_t floats = 0;
  for (const Level& level : levels_) floats += level.highest_m.size();
  return floats * sizeof(float);
}

}  // namespace terrview
#endif

#include "terrain/height_pyramid.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace terrview {
namespace {

constexpr float kNone = -std::numeric_limits<float>::infinity();
constexpr HeightPyramid::Range kEmpty{std::numeric_limits<float>::infinity(), kNone};

HeightPyramid::Range merge(const HeightPyramid::Range& a, const HeightPyramid::Range& b) {
  return {std::min(a.lowest_m, b.lowest_m), std::max(a.highest_m, b.highest_m)};
}

HeightPyramid::Range range_of_posts(const HeightGrid& grid, glm::ivec2 first, glm::ivec2 last) {
  HeightPyramid::Range range = kEmpty;
  bool hole = false;
  for (int row = first.y; row <= last.y; ++row) {
    for (int column = first.x; column <= last.x; ++column) {
      const float height_m = grid.at(column, row);
      hole |= std::isnan(height_m);
      // A comparison with NaN is false and leaves the range.
      range.lowest_m = height_m < range.lowest_m ? height_m : range.lowest_m;
      range.highest_m = height_m > range.highest_m ? height_m : range.highest_m;
    }
  }
  if (hole) range.lowest_m = kNone;
  return range;
}

}  // namespace

HeightPyramid::HeightPyramid(const HeightGrid& grid) {
  levels_.push_back(first_level(grid));
  while (levels_.back().columns > 1 || levels_.back().rows > 1)
    levels_.push_back(coarser(levels_.back()));
}

HeightPyramid::Level HeightPyramid::first_level(const HeightGrid& grid) {
  constexpr int kSide = 1 << kFirstLevel;
  Level level{(grid.columns - 2) / kSide + 1, (grid.rows - 2) / kSide + 1, {}};
  level.blocks.reserve(static_cast<std::size_t>(level.columns) *
                       static_cast<std::size_t>(level.rows));
  const glm::ivec2 last_post(grid.columns - 1, grid.rows - 1);
  for (int row = 0; row < level.rows; ++row) {
    for (int column = 0; column < level.columns; ++column) {
      const glm::ivec2 first(column * kSide, row * kSide);
      const glm::ivec2 last(std::min(first.x + kSide, last_post.x),
                            std::min(first.y + kSide, last_post.y));
      level.blocks.push_back(range_of_posts(grid, first, last));
    }
  }
  return level;
}

HeightPyramid::Level HeightPyramid::coarser(const Level& fine) {
  Level level{(fine.columns + 1) / 2, (fine.rows + 1) / 2, {}};
  level.blocks.assign(
      static_cast<std::size_t>(level.columns) * static_cast<std::size_t>(level.rows), kEmpty);
  for (int row = 0; row < fine.rows; ++row) {
    for (int column = 0; column < fine.columns; ++column) {
      const auto from = static_cast<std::size_t>(row) * static_cast<std::size_t>(fine.columns) +
                        static_cast<std::size_t>(column);
      const auto to = static_cast<std::size_t>(row / 2) * static_cast<std::size_t>(level.columns) +
                      static_cast<std::size_t>(column / 2);
      level.blocks[to] = merge(level.blocks[to], fine.blocks[from]);
    }
  }
  return level;
}

int HeightPyramid::last_level() const { return kFirstLevel + static_cast<int>(levels_.size()) - 1; }

const HeightPyramid::Range& HeightPyramid::block(int level, glm::ivec2 cell) const {
  const Level& blocks = levels_[static_cast<std::size_t>(level - kFirstLevel)];
  return blocks
      .blocks[static_cast<std::size_t>(cell.y >> level) * static_cast<std::size_t>(blocks.columns) +
              static_cast<std::size_t>(cell.x >> level)];
}

}  // namespace terrview

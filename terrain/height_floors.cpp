#include "terrain/height_floors.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace terrview {
namespace {

float lowest_of_posts(const HeightGrid& grid, glm::ivec2 first, glm::ivec2 last) {
  float lowest_m = std::numeric_limits<float>::infinity();
  for (int row = first.y; row <= last.y; ++row) {
    for (int column = first.x; column <= last.x; ++column) {
      const float height_m = grid.at(column, row);
      if (std::isnan(height_m)) return -std::numeric_limits<float>::infinity();
      lowest_m = std::min(lowest_m, height_m);
    }
  }
  return lowest_m;
}

}  // namespace

HeightFloors::HeightFloors(const HeightGrid& grid) {
  levels_.push_back(first_level(grid));
  while (levels_.back().columns > 1 || levels_.back().rows > 1)
    levels_.push_back(coarser(levels_.back()));
}

HeightFloors::Level HeightFloors::first_level(const HeightGrid& grid) {
  constexpr int kSide = 1 << kFirstLevel;
  Level level{(grid.columns - 2) / kSide + 1, (grid.rows - 2) / kSide + 1, {}};
  level.lowest_m.reserve(static_cast<std::size_t>(level.columns) *
                         static_cast<std::size_t>(level.rows));
  const glm::ivec2 last_post(grid.columns - 1, grid.rows - 1);
  for (int row = 0; row < level.rows; ++row) {
    for (int column = 0; column < level.columns; ++column) {
      const glm::ivec2 first(column * kSide, row * kSide);
      const glm::ivec2 last(std::min(first.x + kSide, last_post.x),
                            std::min(first.y + kSide, last_post.y));
      level.lowest_m.push_back(lowest_of_posts(grid, first, last));
    }
  }
  return level;
}

HeightFloors::Level HeightFloors::coarser(const Level& fine) {
  Level level{(fine.columns + 1) / 2, (fine.rows + 1) / 2, {}};
  level.lowest_m.assign(
      static_cast<std::size_t>(level.columns) * static_cast<std::size_t>(level.rows),
      std::numeric_limits<float>::infinity());
  for (int row = 0; row < fine.rows; ++row) {
    for (int column = 0; column < fine.columns; ++column) {
      const auto from = static_cast<std::size_t>(row) * static_cast<std::size_t>(fine.columns) +
                        static_cast<std::size_t>(column);
      const auto to = static_cast<std::size_t>(row / 2) * static_cast<std::size_t>(level.columns) +
                      static_cast<std::size_t>(column / 2);
      level.lowest_m[to] = std::min(level.lowest_m[to], fine.lowest_m[from]);
    }
  }
  return level;
}

int HeightFloors::last_level() const { return kFirstLevel + static_cast<int>(levels_.size()) - 1; }

float HeightFloors::lowest_m(int level, glm::ivec2 cell) const {
  const Level& blocks = levels_[static_cast<std::size_t>(level - kFirstLevel)];
  return blocks.lowest_m[static_cast<std::size_t>(cell.y >> level) *
                             static_cast<std::size_t>(blocks.columns) +
                         static_cast<std::size_t>(cell.x >> level)];
}

}  // namespace terrview

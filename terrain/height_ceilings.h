// The highest heights of small blocks of cells: what keeps the ground below a ray.
//
// A block of level L is 2^L x 2^L cells, L >= 1; its ceiling takes in every post of its cells,
// borders included, so it bounds the surface inside under every SurfaceModel. All levels together
// take a third of the heights' memory.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include <glm/vec2.hpp>

#include "terrain/for_each.h"
#include "terrain/height_grid.h"

namespace terrview {

class HeightCeilings {
 public:
  struct Level {
    int columns;  // of blocks
    int rows;
    std::unique_ptr<float[]> highest_m;  // row by row; -infinity where no post has a height

    [[nodiscard]] std::size_t blocks() const {
      return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    }
  };

  explicit HeightCeilings(const HeightGrid& grid, const ForEach& for_each = one_by_one);

  // The coarsest level is one block.
  [[nodiscard]] int last_level() const { return static_cast<int>(levels_.size()); }
  [[nodiscard]] const Level& level(int level) const {
    return levels_[static_cast<std::size_t>(level - 1)];
  }
  // The ceiling of the block of `level` that holds the cell.
  [[nodiscard]] float highest_m(int of_level, glm::ivec2 cell) const {
    const Level& blocks = level(of_level);
    return blocks.highest_m[static_cast<std::size_t>(cell.y >> of_level) *
                                static_cast<std::size_t>(blocks.columns) +
                            static_cast<std::size_t>(cell.x >> of_level)];
  }
  [[nodiscard]] std::size_t bytes() const;

 private:
  std::vector<Level> levels_;
};

}  // namespace terrview

// Lowest and highest heights of blocks of cells, for skipping what a ray cannot meet.
//
// A block of level L is 2^L x 2^L cells; its range takes in every post of its cells, borders
// included, so it bounds the surface inside under every SurfaceModel. Levels start at kFirstLevel:
// the whole pyramid takes 2 / 4^kFirstLevel * 4 / 3 of the heights' memory, 4 percent.
#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "terrain/height_grid.h"

namespace terrview {

class HeightPyramid {
 public:
  static constexpr int kFirstLevel = 3;

  struct Range {
    float lowest_m;   // -infinity where a cell of the block is a hole
    float highest_m;  // -infinity where the block has no post with a height
  };

  explicit HeightPyramid(const HeightGrid& grid);

  // The coarsest level; its blocks cover the grid 1 x 1 or the pyramid ends there. Below
  // kFirstLevel if the grid is too small for any.
  [[nodiscard]] int last_level() const;

  // The block of `level` that holds the cell.
  [[nodiscard]] const Range& block(int level, glm::ivec2 cell) const;

 private:
  struct Level {
    int columns;
    int rows;
    std::vector<Range> blocks;
  };
  [[nodiscard]] static Level first_level(const HeightGrid& grid);
  [[nodiscard]] static Level coarser(const Level& fine);

  std::vector<Level> levels_;
};

}  // namespace terrview

// The highest heights of small blocks of cells: what keeps the ground below a ray.
//
// A block of level L is 2^L x 2^L cells, L >= 1; its ceiling takes in every post of its cells,
// borders included, so it bounds the surface inside under every SurfaceModel. All levels together
// take a third of the heights' memory.
#pragma once

#include <vector>

#include "terrain/height_grid.h"

namespace terrview {

class HeightCeilings {
 public:
  struct Level {
    int columns;  // of blocks
    int rows;
    std::vector<float> highest_m;  // row by row; -infinity where no post has a height
  };

  explicit HeightCeilings(const HeightGrid& grid);

  // The coarsest level is one block.
  [[nodiscard]] int last_level() const { return static_cast<int>(levels_.size()); }
  [[nodiscard]] const Level& level(int level) const {
    return levels_[static_cast<std::size_t>(level - 1)];
  }
  [[nodiscard]] std::size_t bytes() const;

 private:
  std::vector<Level> levels_;
};

}  // namespace terrview

// The lowest heights of blocks of cells, and which blocks have holes.
//
// A block of level L is 2^L x 2^L cells, L >= kFirstLevel; its floor takes in every post of its
// cells, borders included, so it bounds the surface inside under every SurfaceModel. All levels
// together take 2 percent of the heights' memory.
#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "terrain/height_grid.h"

namespace terrview {

class HeightFloors {
 public:
  static constexpr int kFirstLevel = 3;

  explicit HeightFloors(const HeightGrid& grid);

  // The coarsest level is one block.
  [[nodiscard]] int last_level() const;

  // The floor of the block of `level` that holds the cell; -infinity where a cell of it is a hole.
  [[nodiscard]] float lowest_m(int level, glm::ivec2 cell) const;

 private:
  struct Level {
    int columns;
    int rows;
    std::vector<float> lowest_m;
  };
  [[nodiscard]] static Level first_level(const HeightGrid& grid);
  [[nodiscard]] static Level coarser(const Level& fine);

  std::vector<Level> levels_;
};

}  // namespace terrview

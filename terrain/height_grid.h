// A digital elevation model on its own posts.
//
// Grid frame: u counts posts along a row, v counts rows downwards in file order; post (c, r) is at
// u = c, v = r, and the ground lies between the outermost posts, 0 <= u <= columns - 1. The grid
// knows nothing of where it lies on the Earth: that is the business of GroundMap and VerticalFrame.
#pragma once

#include <cassert>
#include <cmath>
#include <cstddef>
#include <vector>

#include <glm/vec2.hpp>

namespace terrview {

struct HeightGrid {
  int columns = 0;
  int rows = 0;
  std::vector<float> heights_m;  // row by row, columns * rows of them; NaN = no data

  [[nodiscard]] float at(int column, int row) const {
    assert(column >= 0 && column < columns && row >= 0 && row < rows);
    return heights_m[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                     static_cast<std::size_t>(column)];
  }

  // Whether all four posts of the cell whose first post is (column, row) have a height. A cell that
  // touches a post without data is a hole.
  [[nodiscard]] bool has_ground(int column, int row) const {
    return !std::isnan(at(column, row)) && !std::isnan(at(column + 1, row)) &&
           !std::isnan(at(column, row + 1)) && !std::isnan(at(column + 1, row + 1));
  }

  [[nodiscard]] bool covers(glm::dvec2 uv) const {
    return uv.x >= 0 && uv.y >= 0 && uv.x <= columns - 1 && uv.y <= rows - 1;
  }
};

struct HeightRange {
  float lowest_m;
  float highest_m;
  bool has_holes = false;  // some post has no height
};

// The range of the heights of `grid`; NaN where no post has a height.
[[nodiscard]] HeightRange height_range(const HeightGrid& grid);

}  // namespace terrview

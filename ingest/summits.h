// The tops of a grid.
#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "terrain/height_grid.h"

namespace terrview {

// A post's top: no post within summit_reach() posts along rows and columns is higher, and none as
// high comes before it. Posts at the border and beside voids are none: the ground may rise beyond.
struct Summit {
  glm::ivec2 post;
  float height_m;
};

// A fortieth of the shorter side of the grid, at least three posts.
[[nodiscard]] int summit_reach(const HeightGrid& grid);

// The `count` highest summits, highest first; fewer if there are fewer.
[[nodiscard]] std::vector<Summit> find_summits(const HeightGrid& grid, std::size_t count);

}  // namespace terrview

// Where in the map a point roughly is: a regular raster with a tile in each of its cells, from
// which a search walks on.
#pragma once

#include <array>
#include <vector>

#include <glm/vec2.hpp>

#include "render/objects/rectangle_ranks.h"
#include "render/objects/rectangle_tiles.h"

namespace terrview {

class RectangleIndex {
 public:
  RectangleIndex(const std::vector<Tile>& tiles, const std::array<Lines, 2>& lines);

  // A tile at or near `at_m`.
  [[nodiscard]] int near(const glm::dvec2& at_m) const {
    const int i = cell(0, (at_m.x - low_m_.x) * cells_per_m_.x);
    const int j = cell(1, (at_m.y - low_m_.y) * cells_per_m_.y);
    return tiles_[static_cast<std::size_t>(j) * static_cast<std::size_t>(size_.x) +
                  static_cast<std::size_t>(i)];
  }

  [[nodiscard]] std::size_t bytes() const { return tiles_.capacity() * sizeof(int); }

 private:
  [[nodiscard]] int cell(int axis, double at) const {
    if (!(at > 0)) return 0;
    return at < size_[axis] ? static_cast<int>(at) : size_[axis] - 1;
  }

  glm::dvec2 low_m_;
  glm::dvec2 cells_per_m_;
  glm::ivec2 size_;
  std::vector<int> tiles_;  // by row: the tile over each cell's centre
};

}  // namespace terrview

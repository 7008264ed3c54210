#include "render/objects/rectangle_index.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace terrview {

RectangleIndex::RectangleIndex(const std::vector<Tile>& tiles, const std::array<Lines, 2>& lines) {
  glm::dvec2 extent_m;
  for (int axis = 0; axis < 2; ++axis) {
    const Lines& it = lines[static_cast<std::size_t>(axis)];
    low_m_[axis] = it.border_m(0);
    extent_m[axis] = it.border_m(it.borders() - 1) - low_m_[axis];
  }
  // As many cells as tiles, about square.
  const auto cells = static_cast<double>(tiles.size());
  const double across = std::sqrt(cells * std::clamp(extent_m.x / extent_m.y, 1 / cells, cells));
  size_.x = std::max(1, static_cast<int>(across > 0 ? across : 1));
  size_.y = std::max(1, static_cast<int>(cells / size_.x));
  for (int axis = 0; axis < 2; ++axis)
    cells_per_m_[axis] = extent_m[axis] > 0 ? size_[axis] / extent_m[axis] : 0;

  tiles_.resize(static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y));
  for (std::size_t tile = 0; tile < tiles.size(); ++tile) {
    glm::ivec2 first;
    glm::ivec2 end;
    for (int axis = 0; axis < 2; ++axis) {
      // The first cell whose centre is at or beyond the border.
      const auto at = [&](int side) {
        const Lines& it = lines[static_cast<std::size_t>(axis)];
        const double border_m = it.border_m(tiles[tile].border[static_cast<std::size_t>(side)]);
        return std::clamp(static_cast<int>((border_m - low_m_[axis]) * cells_per_m_[axis] + 0.5), 0,
                          size_[axis]);
      };
      first[axis] = at(2 * axis);
      end[axis] = at(2 * axis + 1);
    }
    for (int j = first.y; j < end.y; ++j) {
      const auto row = tiles_.begin() + static_cast<std::ptrdiff_t>(j) * size_.x;
      std::fill(row + first.x, row + end.x, static_cast<int>(tile));
    }
  }
}

}  // namespace terrview

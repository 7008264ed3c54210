#include "render/objects/rectangle_cells.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace terrview {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

Range around(const Range& a, const Range& b) {
  return {std::min(a.low_m, b.low_m), std::max(a.high_m, b.high_m)};
}

}  // namespace

RectangleCells::RectangleCells(const std::vector<Box>& boxes, const Box& bounds,
                               const std::vector<Tile>& tiles)
    : low_m_(bounds.lowest_m) {
  const glm::dvec2 extent_m = glm::dvec2(bounds.highest_m) - low_m_;
  const auto count = static_cast<double>(boxes.size());
  const double longest_m = std::max(extent_m.x, extent_m.y);
  cell_m_ = std::max(std::sqrt(extent_m.x / count * extent_m.y), longest_m / count);
  if (!(cell_m_ > 0)) cell_m_ = 1;
  cells_per_m_ = 1 / cell_m_;
  glm::ivec2 size;
  for (int axis = 0; axis < 2; ++axis) {
    size[axis] = std::max(1, static_cast<int>(std::ceil(extent_m[axis] / cell_m_)));
    while (border_m(axis, size[axis]) < bounds.highest_m[axis]) ++size[axis];
  }
  const Heights none{kInfinity, -kInfinity};
  const auto cells = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
  levels_.push_back({size, std::vector<Heights>(cells, none)});
  for (const Box& box : boxes) raise(box);
  while (levels_.back().heights_m.size() > 1) add_level();
  lay(tiles);
}

// The first and the last cell that a closed range touches.
glm::ivec2 RectangleCells::cells_over(int axis, double low_m, double high_m) const {
  const int last = levels_[0].size[axis] - 1;
  glm::ivec2 cells(near(axis, low_m), near(axis, high_m));
  while (cells.x < last && border_m(axis, cells.x + 1) < low_m) ++cells.x;
  while (cells.x > 0 && border_m(axis, cells.x) >= low_m) --cells.x;
  while (cells.y > 0 && border_m(axis, cells.y) > high_m) --cells.y;
  while (cells.y < last && border_m(axis, cells.y + 1) <= high_m) ++cells.y;
  return cells;
}

void RectangleCells::raise(const Box& box) {
  const glm::ivec2 x = cells_over(0, box.lowest_m.x, box.highest_m.x);
  const glm::ivec2 y = cells_over(1, box.lowest_m.y, box.highest_m.y);
  const Heights heights_m = range_around(box.lowest_m.z, box.highest_m.z);
  Level& level = levels_[0];
  for (int j = y.x; j <= y.y; ++j)
    for (int i = x.x; i <= x.y; ++i) {
      Heights& it = level.heights_m[place({i, j}, level.size)];
      it = around(it, heights_m);
    }
}

void RectangleCells::add_level() {
  const Level& below = levels_.back();
  const glm::ivec2 size = (below.size + 1) / 2;
  Level level{size, std::vector<Heights>(
                        static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y),
                        Heights{kInfinity, -kInfinity})};
  for (int j = 0; j < below.size.y; ++j)
    for (int i = 0; i < below.size.x; ++i) {
      Heights& it = level.heights_m[place({i / 2, j / 2}, size)];
      it = around(it, below.heights_m[place({i, j}, below.size)]);
    }
  levels_.push_back(std::move(level));
}

void RectangleCells::lay(const std::vector<Tile>& tiles) {
  const glm::ivec2 size = levels_[0].size;
  tiles_.resize(levels_[0].heights_m.size());
  for (std::size_t tile = 0; tile < tiles.size(); ++tile) {
    const auto& border_m = tiles[tile].border_m;
    // The first cell whose centre is at or beyond the border.
    const auto first = [&](int axis, std::size_t side) {
      const double cell = (static_cast<double>(border_m[side]) - low_m_[axis]) * cells_per_m_ + 0.5;
      return static_cast<int>(std::clamp(cell, 0.0, static_cast<double>(size[axis])));
    };
    const int west = first(0, 0);
    const int east = first(0, 1);
    const int north = first(1, 3);
    for (int j = first(1, 2); j < north; ++j)
      for (int i = west; i < east; ++i) tiles_[place({i, j}, size)] = static_cast<int>(tile);
  }
}

std::size_t RectangleCells::bytes() const {
  std::size_t sum = tiles_.capacity() * sizeof(int);
  for (const Level& level : levels_) sum += level.heights_m.capacity() * sizeof(Heights);
  return sum;
}

}  // namespace terrview

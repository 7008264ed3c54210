#include "render/objects/height_cells.h"

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

double HeightCells::cell_m(const glm::dvec2& extent_m, std::size_t objects) {
  const auto count = static_cast<double>(objects);
  const double longest_m = std::max(extent_m.x, extent_m.y);
  const double side_m = std::max(std::sqrt(2 * extent_m.x / count * extent_m.y), longest_m / count);
  return side_m > 0 ? side_m : 1;
}

HeightCells::HeightCells(const std::vector<Box>& boxes, const Box& bounds)
    : low_m_(bounds.lowest_m) {
  const glm::dvec2 extent_m = glm::dvec2(bounds.highest_m) - low_m_;
  cell_m_ = cell_m(extent_m, boxes.size());
  cells_per_m_ = 1 / cell_m_;
  glm::ivec2 size;
  for (int axis = 0; axis < 2; ++axis) {
    size[axis] = std::max(1, static_cast<int>(std::ceil(extent_m[axis] / cell_m_)));
    while (border_m(axis, size[axis]) < bounds.highest_m[axis]) ++size[axis];
  }
  const Heights none{kInfinity, -kInfinity};
  const auto cells = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
  levels_.push_back({size, std::vector<Heights>(cells, none)});
  for (const Box& box : boxes) {
    const Heights heights_m = range_around(box.lowest_m.z, box.highest_m.z);
    over(box, [&](std::size_t cell) {
      Heights& it = levels_[0].heights_m[cell];
      it = around(it, heights_m);
    });
  }
  while (levels_.back().heights_m.size() > 1) add_level();
}

// The first and the last cell that a closed range touches.
glm::ivec2 HeightCells::cells_over(int axis, double low_m, double high_m) const {
  const int last = levels_[0].size[axis] - 1;
  glm::ivec2 cells(near(axis, low_m), near(axis, high_m));
  while (cells.x < last && border_m(axis, cells.x + 1) < low_m) ++cells.x;
  while (cells.x > 0 && border_m(axis, cells.x) >= low_m) --cells.x;
  while (cells.y > 0 && border_m(axis, cells.y) > high_m) --cells.y;
  while (cells.y < last && border_m(axis, cells.y + 1) <= high_m) ++cells.y;
  return cells;
}

void HeightCells::add_level() {
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

std::size_t HeightCells::bytes() const {
  std::size_t sum = 0;
  for (const Level& level : levels_) sum += level.heights_m.capacity() * sizeof(Heights);
  return sum;
}

}  // namespace terrview

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

std::size_t place_of(const glm::ivec2& cell, const glm::ivec2& size) {
  return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(size.x) +
         static_cast<std::size_t>(cell.x);
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
  place(tiles);
}

// The cell at or near a coordinate.
int RectangleCells::near(int axis, double at_m) const {
  const double cell = (at_m - low_m_[axis]) / cell_m_;
  const int last = levels_[0].size[axis] - 1;
  if (!(cell > 0)) return 0;
  return cell < last ? static_cast<int>(cell) : last;
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
      Heights& it = level.heights_m[place_of({i, j}, level.size)];
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
      Heights& it = level.heights_m[place_of({i / 2, j / 2}, size)];
      it = around(it, below.heights_m[place_of({i, j}, below.size)]);
    }
  levels_.push_back(std::move(level));
}

void RectangleCells::place(const std::vector<Tile>& tiles) {
  const glm::ivec2 size = levels_[0].size;
  tiles_.resize(levels_[0].heights_m.size());
  for (std::size_t tile = 0; tile < tiles.size(); ++tile) {
    const auto& border_m = tiles[tile].border_m;
    // The first cell whose centre is at or beyond the border.
    const auto first = [&](int axis, std::size_t side) {
      const double cell = (static_cast<double>(border_m[side]) - low_m_[axis]) / cell_m_ + 0.5;
      return static_cast<int>(std::clamp(cell, 0.0, static_cast<double>(size[axis])));
    };
    const int west = first(0, 0);
    const int east = first(0, 1);
    const int north = first(1, 3);
    for (int j = first(1, 2); j < north; ++j)
      for (int i = west; i < east; ++i) tiles_[place_of({i, j}, size)] = static_cast<int>(tile);
  }
}

std::size_t RectangleCells::bytes() const {
  std::size_t sum = tiles_.capacity() * sizeof(int);
  for (const Level& level : levels_) sum += level.heights_m.capacity() * sizeof(Heights);
  return sum;
}

CellWalk::CellWalk(const RectangleCells& cells, const SlabRay& slabs, double from_m)
    : cells_(cells), slabs_(slabs), at_m_(from_m) {
  for (int axis = 0; axis < 2; ++axis)
    at_[axis] = cell_at(axis, from_m, 0, cells.levels_[0].size[axis] - 1);
}

// Where the ray passes a border between cells; never, if it lies in it.
double CellWalk::border_m(int axis, int border) const {
  const double distance_m = slabs_.distance_m(axis, cells_.border_m(axis, border));
  return std::isnan(distance_m) ? std::numeric_limits<double>::infinity() : distance_m;
}

// Among cells [low, high], that which holds the ray's point at a distance.
int CellWalk::cell_at(int axis, double distance_m, int low, int high) const {
  int cell = std::clamp(cells_.near(axis, slabs_.at_m(axis, distance_m)), low, high);
  if (slabs_.backward(axis)) {
    while (cell > low && border_m(axis, cell) < distance_m) --cell;
    while (cell < high && border_m(axis, cell + 1) > distance_m) ++cell;
  } else {
    while (cell < high && border_m(axis, cell + 1) < distance_m) ++cell;
    while (cell > low && border_m(axis, cell) > distance_m) --cell;
  }
  return cell;
}

std::optional<Stretch> CellWalk::next(double leave_m) {
  while (at_m_ <= leave_m) {
    const auto& level = cells_.levels_[level_];
    const int shift = static_cast<int>(level_);
    const glm::ivec2 block(at_.x >> shift, at_.y >> shift);
    if (at_.x < 0 || at_.y < 0 || block.x >= level.size.x || block.y >= level.size.y) break;
    const double x_m = border_m(0, (block.x + (slabs_.backward(0) ? 0 : 1)) << shift);
    const double y_m = border_m(1, (block.y + (slabs_.backward(1) ? 0 : 1)) << shift);
    const double out_m = std::min(x_m, y_m);
    const auto& heights_m = level.heights_m[place_of(block, level.size)];
    Stretch stretch{at_m_, std::min(out_m, leave_m)};
    // In this order, a NaN changes nothing.
    const bool down = slabs_.backward(2);
    stretch.enter_m = std::max(
        stretch.enter_m,
        slabs_.distance_m(2, static_cast<double>(down ? heights_m.high_m : heights_m.low_m)));
    stretch.leave_m = std::min(
        stretch.leave_m,
        slabs_.distance_m(2, static_cast<double>(down ? heights_m.low_m : heights_m.high_m)));
    const bool is_met = stretch.enter_m <= stretch.leave_m;
    if (is_met && level_ > 0) {
      --level_;
      continue;
    }
    if (is_met) tile_ = cells_.tiles_[place_of(at_, level.size)];
    leave_block(x_m < y_m ? 0 : 1, out_m);
    if (is_met) return stretch;
    if (level_ + 1 < cells_.levels_.size()) ++level_;
  }
  return std::nullopt;
}

void CellWalk::leave_block(int axis, double at_m) {
  at_m_ = at_m;
  const int shift = static_cast<int>(level_);
  const int block = at_[axis] >> shift;
  at_[axis] = slabs_.backward(axis) ? (block << shift) - 1 : (block + 1) << shift;
  if (level_ == 0 || std::isinf(at_m)) return;
  const int other = 1 - axis;
  const int first = (at_[other] >> shift) << shift;
  const int last = std::min(first + (1 << shift), cells_.levels_[0].size[other]) - 1;
  at_[other] = cell_at(other, at_m, first, last);
}

}  // namespace terrview

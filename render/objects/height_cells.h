// Where over the plane a ray is at the height of objects.
//
// Square cells, about one for every two objects, with the lowest and the highest point of the
// objects over each, and a pyramid of them (as Tevs, Ihrke & Seidel, I3D 2008, walk heights): what
// the ray passes over or under is skipped in steps as large as can be.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include "render/objects/rectangle_ranks.h"
#include "render/objects/slab_ray.h"

namespace terrview {

class HeightCells {
 public:
  HeightCells(const std::vector<Box>& boxes, const Box& bounds);

  // The side of the cells for so many objects: about two of them to a cell.
  [[nodiscard]] static double cell_m(const glm::dvec2& extent_m, std::size_t objects);

  [[nodiscard]] const glm::ivec2& size() const { return levels_[0].size; }

  // The number of a cell, by row.
  [[nodiscard]] std::size_t place(const glm::ivec2& cell) const { return place(cell, size()); }

  // The cell at or near a point.
  [[nodiscard]] glm::ivec2 near(const glm::dvec2& at_m) const {
    return {near(0, at_m.x), near(1, at_m.y)};
  }

  // The first cell along an axis whose centre is at or beyond a coordinate; their number, if none
  // is.
  [[nodiscard]] int first_centre(int axis, double at_m) const {
    const double cell = (at_m - low_m_[axis]) * cells_per_m_ + 0.5;
    return static_cast<int>(std::clamp(cell, 0.0, static_cast<double>(size()[axis])));
  }

  // Calls visit(number) for each cell that a closed box touches.
  template <class Visit>
  void over(const Box& box, const Visit& visit) const {
    const glm::ivec2 x = cells_over(0, box.lowest_m.x, box.highest_m.x);
    const glm::ivec2 y = cells_over(1, box.lowest_m.y, box.highest_m.y);
    for (int j = y.x; j <= y.y; ++j)
      for (int i = x.x; i <= x.y; ++i) visit(place({i, j}));
  }

  [[nodiscard]] std::size_t bytes() const;

 private:
  friend class CellWalk;

  // Heights; none where low_m > high_m.
  using Heights = Range;

  struct Level {
    glm::ivec2 size;
    std::vector<Heights> heights_m;  // by row
  };

  [[nodiscard]] double border_m(int axis, int border) const {
    return low_m_[axis] + border * cell_m_;
  }
  static std::size_t place(const glm::ivec2& cell, const glm::ivec2& size) {
    return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(size.x) +
           static_cast<std::size_t>(cell.x);
  }
  // The cell at or near a coordinate.
  [[nodiscard]] int near(int axis, double at_m) const {
    const double cell = (at_m - low_m_[axis]) * cells_per_m_;
    const int last = levels_[0].size[axis] - 1;
    if (!(cell > 0)) return 0;
    return cell < last ? static_cast<int>(cell) : last;
  }
  [[nodiscard]] glm::ivec2 cells_over(int axis, double low_m, double high_m) const;
  void add_level();

  glm::dvec2 low_m_;
  double cell_m_;
  double cells_per_m_;
  std::vector<Level> levels_;  // the cells first
};

// One ray's walk over the cells.
class CellWalk {
 public:
  CellWalk(const HeightCells& cells, const SlabRay& slabs, double from_m);

  // The next stretch, up to leave_m, of the ray within one cell and between its heights. Every
  // point of a box within its cells' heights is on one.
  [[nodiscard]] std::optional<Stretch> next(double leave_m);

  // The cell of that stretch, by its number.
  [[nodiscard]] std::size_t cell() const { return cell_; }

 private:
  [[nodiscard]] double border_m(int axis, int border) const {
    return slabs_.distance_m(axis, cells_.border_m(axis, border));
  }
  [[nodiscard]] int cell_at(int axis, double distance_m) const;
  void descend();

  const HeightCells& cells_;
  const SlabRay slabs_;
  glm::ivec2 ahead_;  // 1 where the ray leaves a block by its higher border
  glm::ivec2 block_;  // of a level, in which the ray is at
  double at_m_;
  int level_ = 0;
  std::size_t cell_ = 0;
};

inline CellWalk::CellWalk(const HeightCells& cells, const SlabRay& slabs, double from_m)
    : cells_(cells),
      slabs_(slabs),
      ahead_(slabs.backward(0) ? 0 : 1, slabs.backward(1) ? 0 : 1),
      at_m_(from_m) {
  block_ = {cell_at(0, from_m), cell_at(1, from_m)};
}

// The cell that holds the ray's point at a distance.
inline int CellWalk::cell_at(int axis, double distance_m) const {
  const int last = cells_.size()[axis] - 1;
  int cell = cells_.near(axis, slabs_.at_m(axis, distance_m));
  if (slabs_.backward(axis)) {
    while (cell > 0 && border_m(axis, cell) < distance_m) --cell;
    while (cell < last && border_m(axis, cell + 1) > distance_m) ++cell;
  } else {
    while (cell < last && border_m(axis, cell + 1) < distance_m) ++cell;
    while (cell > 0 && border_m(axis, cell) > distance_m) --cell;
  }
  return cell;
}

// Into that of the four parts of the block in which the ray is.
inline void CellWalk::descend() {
  --level_;
  for (int axis = 0; axis < 2; ++axis) {
    const bool beyond = border_m(axis, (2 * block_[axis] + 1) << level_) <= at_m_;
    block_[axis] = 2 * block_[axis] + (beyond ? ahead_[axis] : 1 - ahead_[axis]);
  }
}

[[gnu::always_inline]] inline std::optional<Stretch> CellWalk::next(double leave_m) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  while (at_m_ <= leave_m) {
    const auto& level = cells_.levels_[static_cast<std::size_t>(level_)];
    if (block_.x < 0 || block_.y < 0 || block_.x >= level.size.x || block_.y >= level.size.y) break;
    // In this order, a NaN becomes never: a ray in a border does not pass it.
    const double x_m = std::min(kNever, border_m(0, (block_.x + ahead_.x) << level_));
    const double y_m = std::min(kNever, border_m(1, (block_.y + ahead_.y) << level_));
    const double out_m = std::min(x_m, y_m);
    const auto& heights_m = level.heights_m[HeightCells::place(block_, level.size)];
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
      descend();
      continue;
    }
    if (is_met) cell_ = cells_.place(block_);
    at_m_ = out_m;
    const int axis = x_m < y_m ? 0 : 1;
    const int before = block_[axis];
    block_[axis] += 2 * ahead_[axis] - 1;
    if (is_met) return stretch;
    // What is around both blocks was looked at on the way down.
    if ((block_[axis] >> 1) != (before >> 1) &&
        level_ + 1 < static_cast<int>(cells_.levels_.size())) {
      block_ >>= 1;
      ++level_;
    }
  }
  return std::nullopt;
}

}  // namespace terrview

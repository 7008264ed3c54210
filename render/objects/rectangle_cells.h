// Where over the plane a ray is at the height of objects, and which tile is there.
//
// Square cells, about one for each object, with the lowest and the highest point of the objects
// over each, and a pyramid of them (as Tevs, Ihrke & Seidel, I3D 2008, walk heights): what the ray
// passes over or under is skipped in steps as large as can be.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include "render/objects/rectangle_tiles.h"
#include "render/objects/slab_ray.h"

namespace terrview {

class RectangleCells {
 public:
  RectangleCells(const std::vector<Box>& boxes, const Box& bounds, const std::vector<Tile>& tiles);

  // A tile at or near a point.
  [[nodiscard]] int tile_near(const glm::dvec2& at_m) const {
    return tiles_[place({near(0, at_m.x), near(1, at_m.y)}, levels_[0].size)];
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
  void raise(const Box& box);
  void add_level();
  void lay(const std::vector<Tile>& tiles);

  glm::dvec2 low_m_;
  double cell_m_;
  double cells_per_m_;
  std::vector<Level> levels_;  // the cells first
  std::vector<int> tiles_;     // by row of cells: the tile at the centre of each
};

// One ray's walk over the cells.
class CellWalk {
 public:
  CellWalk(const RectangleCells& cells, const SlabRay& slabs, double from_m);

  // The next stretch, up to leave_m, of the ray within one cell and between its heights. Every
  // point of a box within its cells' heights is on one.
  [[nodiscard]] std::optional<Stretch> next(double leave_m);

  // A tile at or near the last stretch.
  [[nodiscard]] int tile() const { return tile_; }

 private:
  [[nodiscard]] double border_m(int axis, int border) const;
  [[nodiscard]] int cell_at(int axis, double distance_m, int low, int high) const;
  void leave_block(int axis, double at_m);

  const RectangleCells& cells_;
  const SlabRay& slabs_;
  glm::ivec2 at_;
  double at_m_;
  std::size_t level_ = 0;
  int tile_ = 0;
};

inline CellWalk::CellWalk(const RectangleCells& cells, const SlabRay& slabs, double from_m)
    : cells_(cells), slabs_(slabs), at_m_(from_m) {
  for (int axis = 0; axis < 2; ++axis)
    at_[axis] = cell_at(axis, from_m, 0, cells.levels_[0].size[axis] - 1);
}

// Where the ray passes a border between cells; never, if it lies in it.
inline double CellWalk::border_m(int axis, int border) const {
  const double distance_m = slabs_.distance_m(axis, cells_.border_m(axis, border));
  return std::isnan(distance_m) ? std::numeric_limits<double>::infinity() : distance_m;
}

// Among cells [low, high], that which holds the ray's point at a distance.
inline int CellWalk::cell_at(int axis, double distance_m, int low, int high) const {
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

inline std::optional<Stretch> CellWalk::next(double leave_m) {
  while (at_m_ <= leave_m) {
    const auto& level = cells_.levels_[level_];
    const int shift = static_cast<int>(level_);
    const glm::ivec2 block(at_.x >> shift, at_.y >> shift);
    if (at_.x < 0 || at_.y < 0 || block.x >= level.size.x || block.y >= level.size.y) break;
    const double x_m = border_m(0, (block.x + (slabs_.backward(0) ? 0 : 1)) << shift);
    const double y_m = border_m(1, (block.y + (slabs_.backward(1) ? 0 : 1)) << shift);
    const double out_m = std::min(x_m, y_m);
    const auto& heights_m = level.heights_m[RectangleCells::place(block, level.size)];
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
    if (is_met) tile_ = cells_.tiles_[RectangleCells::place(at_, level.size)];
    leave_block(x_m < y_m ? 0 : 1, out_m);
    if (is_met) return stretch;
    if (level_ + 1 < cells_.levels_.size()) ++level_;
  }
  return std::nullopt;
}

inline void CellWalk::leave_block(int axis, double at_m) {
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

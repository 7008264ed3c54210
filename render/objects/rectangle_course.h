// The way of a ray from tile to tile.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "render/objects/rectangle_index.h"
#include "render/objects/rectangle_ranks.h"
#include "render/objects/rectangle_tiles.h"
#include "render/objects/slab_ray.h"

namespace terrview {

// The plane in tiles.
struct TiledPlane {
  std::array<int, 2> axes;  // which of the three span it
  std::array<Lines, 2> lines;
  Tiles tiles;
  RectangleIndex index;
};

// The passing of a border. Of two at one distance, entering a line comes before leaving one, so
// that a ray through a corner is in the corner's tile for a moment.
struct Passing {
  double at_m;
  int leaves;

  [[nodiscard]] bool before(const Passing& other) const {
    return at_m < other.at_m || (at_m == other.at_m && leaves < other.leaves);
  }
};

class Course {
 public:
  static constexpr int kEdge = -1;

  Course(const TiledPlane& plane, const SlabRay& slabs)
      : plane_(plane),
        slabs_(slabs),
        backward_{slabs.backward(plane.axes[0]), slabs.backward(plane.axes[1])} {}

  [[nodiscard]] const Tile& tile(int i) const {
    return plane_.tiles.tiles[static_cast<std::size_t>(i)];
  }

  // The tile that holds the ray's point at a distance within the bounds: walks there from one near
  // it, along one axis and then along the other.
  [[nodiscard]] int tile_at(double distance_m, std::int64_t& steps) const {
    const Passing all_entered{distance_m, 1};
    int at = plane_.index.near(
        {slabs_.at_m(plane_.axes[0], distance_m), slabs_.at_m(plane_.axes[1], distance_m)});
    for (std::size_t axis = 0; axis < 2; ++axis)
      for (;; ++steps) {
        const Tile& it = tile(at);
        if (!passing(axis, it.border[near_side(axis)]).before(all_entered)) {
          at = beyond(it, near_side(axis), all_entered);
        } else if (passing(axis, it.border[far_side(axis)]).before(all_entered)) {
          at = beyond(it, far_side(axis), all_entered);
        } else {
          break;
        }
      }
    return at;
  }

  struct Exit {
    Passing passing;
    std::size_t side;
  };

  [[nodiscard]] Exit exit(const Tile& from) const {
    const Exit x{passing(0, from.border[far_side(0)]), far_side(0)};
    const Exit y{passing(1, from.border[far_side(1)]), far_side(1)};
    return y.passing.before(x.passing) ? y : x;
  }

  // The neighbour beyond a side where the ray is at a passing, or else the nearest to that.
  [[nodiscard]] int beyond(const Tile& from, std::size_t side, const Passing& at) const {
    if (from.count[side] == 0) return kEdge;
    const std::size_t along = 1 - side / 2;
    const Neighbour* first = plane_.tiles.neighbours.data() + from.first[side];
    const Neighbour* last = first + from.count[side] - 1;
    const auto reached = [&](const Neighbour& it) {
      return passing(along, it.end).before(at) == backward_[along];
    };
    constexpr std::ptrdiff_t kFew = 8;
    while (last - first > kFew) {
      const Neighbour* const half = first + (last - first) / 2;
      if (reached(*half)) {
        last = half;
      } else {
        first = half + 1;
      }
    }
    while (first != last && !reached(*first)) ++first;
    return first->tile;
  }

 private:
  [[nodiscard]] std::size_t near_side(std::size_t axis) const {
    return 2 * axis + (backward_[axis] ? 1 : 0);
  }
  [[nodiscard]] std::size_t far_side(std::size_t axis) const {
    return 2 * axis + (backward_[axis] ? 0 : 1);
  }

  [[nodiscard]] Passing passing(std::size_t axis, int border) const {
    const int leaves = (border & 1) ^ (backward_[axis] ? 1 : 0);
    const double at_m = slabs_.distance_m(plane_.axes[axis], plane_.lines[axis].border_m(border));
    if (!std::isnan(at_m)) return {at_m, leaves};
    // A ray along a line entered it before all else and never leaves it.
    constexpr double kNever = std::numeric_limits<double>::infinity();
    return {leaves != 0 ? kNever : -kNever, leaves};
  }

  const TiledPlane& plane_;
  const SlabRay& slabs_;
  std::array<bool, 2> backward_;
};

}  // namespace terrview

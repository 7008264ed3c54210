// The way of a ray from tile to tile.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "render/objects/rectangle_tiles.h"
#include "render/objects/slab_ray.h"

namespace terrview {

// The passing of a border. Of two at one distance, entering a line comes before leaving one, so
// that a ray through a corner is in the corner's tile for a moment.
struct Passing {
  double at_m;
  bool leaves;

  [[nodiscard]] bool before(const Passing& other) const {
    // Ties are rare: without them, this is one comparison.
    if (at_m == other.at_m) [[unlikely]]
      return !leaves && other.leaves;
    return at_m < other.at_m;
  }
};

class Course {
 public:
  Course(const Tiles& tiles, const SlabRay& slabs)
      : tiles_(tiles), slabs_(slabs), backward_{slabs.backward(0), slabs.backward(1)} {}

  [[nodiscard]] const Tile& tile(int i) const { return tiles_.tiles[static_cast<std::size_t>(i)]; }

  // The tile that holds the ray's point at a distance within the bounds: walks there from another,
  // along x and then along y.
  [[nodiscard]] int tile_at(double distance_m, int from, std::int64_t& steps) const {
    const Passing all_entered{distance_m, true};
    int at = from;
    for (std::size_t axis = 0; axis < 2; ++axis)
      for (;; ++steps) {
        const Tile& it = tile(at);
        if (!passing(it, near_side(axis)).before(all_entered)) {
          at = beyond(it, near_side(axis), all_entered);
        } else if (passing(it, far_side(axis)).before(all_entered)) {
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
    const Passing x = passing(from, far_side(0));
    const Passing y = passing(from, far_side(1));
    const bool is_y = y.before(x);
    return {is_y ? y : x, is_y ? far_side(1) : far_side(0)};
  }

  // The neighbour beyond a side where the ray is at a passing, or else the nearest to that.
  [[nodiscard]] int beyond(const Tile& from, std::size_t side, const Passing& at) const {
    const int single = from.beyond[side];
    if (single >= Tile::kEdge) return single;
    const std::size_t along = 1 - side / 2;
    const Neighbour* first = tiles_.neighbours.data() - 2 - single;
    const Neighbour* last = first + first->tile;
    ++first;
    const auto reached = [&](const Neighbour& it) {
      return passing(along, it.end_m, it.is_behind != 0).before(at) == backward_[along];
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
    return static_cast<int>(first->tile);
  }

 private:
  [[nodiscard]] std::size_t near_side(std::size_t axis) const {
    return 2 * axis + (backward_[axis] ? 1 : 0);
  }
  [[nodiscard]] std::size_t far_side(std::size_t axis) const {
    return 2 * axis + (backward_[axis] ? 0 : 1);
  }

  [[nodiscard]] Passing passing(const Tile& tile, std::size_t side) const {
    return passing(side / 2, tile.border_m[side], (tile.is_behind >> side & 1) != 0);
  }

  [[nodiscard]] Passing passing(std::size_t axis, float border_m, bool is_behind) const {
    const bool leaves = is_behind != backward_[axis];
    const double at_m = slabs_.distance_m(static_cast<int>(axis), static_cast<double>(border_m));
    if (!std::isnan(at_m)) return {at_m, leaves};
    // A ray along a line entered it before all else and never leaves it.
    constexpr double kNever = std::numeric_limits<double>::infinity();
    return {leaves ? kNever : -kNever, leaves};
  }

  const Tiles& tiles_;
  const SlabRay& slabs_;
  std::array<bool, 2> backward_;
};

}  // namespace terrview

// The rectangles of a partition and which lies beyond which side of another.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "render/objects/rectangle_partition.h"

namespace terrview {

// The sides are west, east, south, north: 2 * axis, or 2 * axis + 1 for the higher one.
inline constexpr std::size_t kSides = 4;

struct Tile {
  static constexpr int kEdge = -1;  // of the whole

  std::array<float, kSides> border_m;
  // The tile beyond each side; where there are several, -2 minus the place of their number; or
  // kEdge.
  std::array<int, kSides> beyond;
  // The object over it; where there are several, -2 minus their list; or Rectangle::kEmpty.
  int over;
  unsigned is_behind;  // a bit per side: whether its border is the one behind its line
};

// One of several beyond a side, in rising order along it; before the first of them stands their
// number, as the `tile` of one more.
struct Neighbour {
  float end_m;             // the border at which it ends
  unsigned is_behind : 1;  // its line
  unsigned tile : 31;
};

struct Tiles {
  std::vector<Tile> tiles;
  std::vector<Neighbour> neighbours;
};

// O(n log n), linear where few rectangles share a line.
[[nodiscard]] Tiles link(const Partition& partition, const Lines& x, const Lines& y);

}  // namespace terrview

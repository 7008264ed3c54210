// The rectangles of a partition and which lies beyond which side of another.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "render/objects/rectangle_partition.h"

namespace terrview {

struct Neighbour {
  int end;  // the border along the side at which it ends
  int tile;
};

// The sides are west, east, south, north: 2 * axis, or 2 * axis + 1 for the higher one.
inline constexpr int kSides = 4;

// One line of the cache.
struct alignas(64) Tile {
  std::array<int, kSides> border;
  std::array<std::uint32_t, kSides> first;  // of its neighbours beyond each side, rising along it;
  std::array<std::uint32_t, kSides> count;  // none at the edge of the whole
  int list;                                 // of Partition::lists, or Rectangle::kEmpty
};

struct Tiles {
  std::vector<Tile> tiles;
  std::vector<Neighbour> neighbours;
};

// O(n).
[[nodiscard]] Tiles link(const std::vector<Rectangle>& rectangles);

}  // namespace terrview

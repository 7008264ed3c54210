#include "render/objects/rectangle_tiles.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace terrview {
namespace {

class Linker {
 public:
  explicit Linker(const std::vector<Rectangle>& rectangles) : tiles_(rectangles.size()) {
    for (std::size_t i = 0; i < tiles_.size(); ++i) {
      const Rectangle& it = rectangles[i];
      tiles_[i] = {{it.x.low, it.x.high, it.y.low, it.y.high}, {}, {}, it.list};
    }
    for (auto& side : beyond_) side.reserve(tiles_.size() * 3 / 2);
  }

  // Merges those that end and those that begin at each border across the axis, both in their order
  // along it.
  void link(int axis) {
    const int low = 2 * axis;
    const int high = low + 1;
    const std::vector<int> rising = by_border({}, 2 - low);
    const std::vector<int> ending = by_border(rising, high);
    const std::vector<int> beginning = by_border(rising, low);
    auto left = ending.begin();
    auto right = beginning.begin();
    while (left != ending.end() && right != beginning.end()) {
      const int gap = border(*right, low) - border(*left, high);
      if (gap != 0) {
        ++(gap > 0 ? left : right);
        continue;
      }
      const int left_end = border(*left, 3 - low);
      const int right_end = border(*right, 3 - low);
      const int end = std::min(left_end, right_end);
      if (std::max(border(*left, 2 - low), border(*right, 2 - low)) < end) {
        append(*left, high, {end, *right});
        append(*right, low, {end, *left});
      }
      if (left_end == end) ++left;
      if (right_end == end) ++right;
    }
  }

  Tiles finish() {
    Tiles result;
    std::size_t size = 0;
    for (const auto& side : beyond_) size += side.size();
    result.neighbours.reserve(size);
    for (std::size_t side = 0; side < kSides; ++side) {
      const auto offset = static_cast<std::uint32_t>(result.neighbours.size());
      for (Tile& tile : tiles_) tile.first[side] += offset;
      result.neighbours.insert(result.neighbours.end(), beyond_[side].begin(), beyond_[side].end());
    }
    result.tiles = std::move(tiles_);
    return result;
  }

 private:
  [[nodiscard]] int border(int tile, int side) const {
    return tiles_[static_cast<std::size_t>(tile)].border[static_cast<std::size_t>(side)];
  }

  // All tiles by rising border; equal ones in the order of `order`, or of their own.
  [[nodiscard]] std::vector<int> by_border(const std::vector<int>& order, int side) const {
    const auto value = [&](int tile) { return static_cast<std::size_t>(border(tile, side)); };
    const int size = static_cast<int>(tiles_.size());
    std::vector<int> ends;
    for (int i = 0; i < size; ++i) {
      if (value(i) + 2 > ends.size()) ends.resize(value(i) + 2);
      ++ends[value(i) + 1];
    }
    for (std::size_t i = 1; i < ends.size(); ++i) ends[i] += ends[i - 1];
    std::vector<int> result(tiles_.size());
    for (int i = 0; i < size; ++i) {
      const int tile = order.empty() ? i : order[static_cast<std::size_t>(i)];
      result[static_cast<std::size_t>(ends[value(tile)]++)] = tile;
    }
    return result;
  }

  void append(int tile, int side, Neighbour neighbour) {
    const auto s = static_cast<std::size_t>(side);
    Tile& it = tiles_[static_cast<std::size_t>(tile)];
    if (it.count[s]++ == 0) it.first[s] = static_cast<std::uint32_t>(beyond_[s].size());
    beyond_[s].push_back(neighbour);
  }

  std::vector<Tile> tiles_;
  std::array<std::vector<Neighbour>, kSides> beyond_;
};

}  // namespace

Tiles link(const std::vector<Rectangle>& rectangles) {
  Linker linker(rectangles);
  linker.link(0);
  linker.link(1);
  return linker.finish();
}

}  // namespace terrview

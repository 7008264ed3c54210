#include "render/objects/rectangle_tiles.h"

#include <algorithm>
#include <utility>

namespace terrview {
namespace {

constexpr int kNone = -1;
constexpr unsigned kTileBits = 0x7FFFFFFF;

// Those rectangles that have one side at each border, as chains.
class Chains {
 public:
  Chains(int borders, std::size_t rectangles)
      : first_(static_cast<std::size_t>(borders), kNone), next_(rectangles) {}

  void prepend(int border, int rectangle) {
    int& first = first_[static_cast<std::size_t>(border)];
    next_[static_cast<std::size_t>(rectangle)] = first;
    first = rectangle;
  }
  [[nodiscard]] int first(int border) const { return first_[static_cast<std::size_t>(border)]; }
  [[nodiscard]] int next(int rectangle) const { return next_[static_cast<std::size_t>(rectangle)]; }
  void clear(int border) { first_[static_cast<std::size_t>(border)] = kNone; }

 private:
  std::vector<int> first_;
  std::vector<int> next_;
};

// Finds what is on either side of the borders of one axis.
class Linker {
 public:
  Linker(const std::vector<Rectangle>& rectangles, std::size_t axis, const Lines& lines,
         const Lines& along, Tiles& tiles)
      : rectangles_(rectangles),
        axis_(axis),
        along_(along),
        tiles_(tiles),
        lower_(lines.borders(), rectangles.size()),
        higher_(lines.borders(), rectangles.size()) {}

  void link() {
    const int size = static_cast<int>(rectangles_.size());
    for (int i = size - 1; i >= 0; --i) {
      lower_.prepend(across(i).high, i);
      higher_.prepend(across(i).low, i);
    }
    // In the order of the rectangles, which lie near each other in memory as in the plane.
    for (int i = 0; i < size; ++i) link(across(i).high);
  }

 private:
  struct Place {
    Interval interval;  // along the border
    int rectangle;
  };

  [[nodiscard]] const Rectangle& rectangle(int i) const {
    return rectangles_[static_cast<std::size_t>(i)];
  }
  [[nodiscard]] const Interval& across(int i) const {
    return axis_ == 0 ? rectangle(i).x : rectangle(i).y;
  }

  void collect(Chains& chains, int border, std::vector<Place>& places) const {
    places.clear();
    for (int i = chains.first(border); i != kNone; i = chains.next(i))
      places.push_back({axis_ == 0 ? rectangle(i).y : rectangle(i).x, i});
    chains.clear(border);
    const auto is_lower = [](const Place& a, const Place& b) {
      return a.interval.low < b.interval.low;
    };
    if (!std::ranges::is_sorted(places, is_lower)) std::ranges::sort(places, is_lower);
  }

  // Merges those on both sides in their order along the border.
  void link(int border) {
    if (lower_.first(border) == kNone) return;
    collect(lower_, border, low_places_);
    collect(higher_, border, high_places_);
    auto a = low_places_.begin();
    auto b = high_places_.begin();
    while (a != low_places_.end() && b != high_places_.end()) {
      const int end = std::min(a->interval.high, b->interval.high);
      if (std::max(a->interval.low, b->interval.low) < end) {
        low_run_.push_back(neighbour(end, b->rectangle));
        high_run_.push_back(neighbour(end, a->rectangle));
      }
      if (a->interval.high == end) finish(*a++, 2 * axis_ + 1, low_run_);
      if (b->interval.high == end) finish(*b++, 2 * axis_, high_run_);
    }
  }

  [[nodiscard]] Neighbour neighbour(int end, int tile) const {
    return {along_.border_m(end), end % 2 != 0 ? 1U : 0U, static_cast<unsigned>(tile) & kTileBits};
  }

  void finish(const Place& place, std::size_t side, std::vector<Neighbour>& run) {
    int& beyond = tiles_.tiles[static_cast<std::size_t>(place.rectangle)].beyond[side];
    if (run.size() == 1) {
      beyond = static_cast<int>(run[0].tile);
    } else if (!run.empty()) {
      auto& all = tiles_.neighbours;
      beyond = -2 - static_cast<int>(all.size());
      all.push_back({0, 0, static_cast<unsigned>(run.size()) & kTileBits});
      all.insert(all.end(), run.begin(), run.end());
    }
    run.clear();
  }

  const std::vector<Rectangle>& rectangles_;
  std::size_t axis_;
  const Lines& along_;
  Tiles& tiles_;
  Chains lower_;
  Chains higher_;
  std::vector<Place> low_places_;
  std::vector<Place> high_places_;
  std::vector<Neighbour> low_run_;
  std::vector<Neighbour> high_run_;
};

int over(const Rectangle& it, const IntLists& lists) {
  if (it.list == Rectangle::kEmpty) return it.list;
  const auto list = lists[it.list];
  return list.size() == 1 ? list[0] : -2 - it.list;
}

Tile unlinked(const Rectangle& it, const IntLists& lists, const Lines& x, const Lines& y) {
  const auto behind = [](int border, unsigned side) { return border % 2 != 0 ? 1U << side : 0U; };
  return {
      {x.border_m(it.x.low), x.border_m(it.x.high), y.border_m(it.y.low), y.border_m(it.y.high)},
      {Tile::kEdge, Tile::kEdge, Tile::kEdge, Tile::kEdge},
      over(it, lists),
      behind(it.x.low, 0) | behind(it.x.high, 1) | behind(it.y.low, 2) | behind(it.y.high, 3)};
}

}  // namespace

Tiles link(const Partition& partition, const Lines& x, const Lines& y) {
  const auto& rectangles = partition.rectangles;
  Tiles tiles;
  tiles.tiles.reserve(rectangles.size());
  for (const Rectangle& it : rectangles) tiles.tiles.push_back(unlinked(it, partition.lists, x, y));
  tiles.neighbours.reserve(5 * rectangles.size());
  Linker(rectangles, 0, x, y, tiles).link();
  Linker(rectangles, 1, y, x, tiles).link();
  return tiles;
}

}  // namespace terrview

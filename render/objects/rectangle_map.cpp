#include "render/objects/rectangle_map.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <span>
#include <utility>

#include "render/objects/entry_order.h"
#include "render/objects/object_bounds.h"
#include "render/objects/plane_order.h"
#include "render/objects/rectangle_course.h"
#include "render/objects/rectangle_ranks.h"

namespace terrview {
namespace {

// Tiles that a ray goes through before it looks farther ahead: looking costs as much as some of
// them.
constexpr int kPatience = 4;

std::vector<int> neighbours_together(const std::vector<Box>& boxes, const Box& bounds) {
  const int bits = order_bits(boxes.size());
  std::vector<std::uint32_t> keys;
  keys.reserve(boxes.size());
  const auto place = [&](const Box& box, int axis) {
    const double low_m = bounds.lowest_m[axis];
    const double share = (box.lowest_m[axis] - low_m) / (bounds.highest_m[axis] - low_m);
    return share > 0 ? static_cast<std::uint32_t>(std::min(share, 1.0) * ((1 << bits) - 1)) : 0U;
  };
  for (const Box& box : boxes) keys.push_back(interleaved(place(box, 0), place(box, 1)));
  return order_of(keys);
}

std::vector<Range> ranges(const std::vector<Box>& boxes, int axis) {
  std::vector<Range> ranges;
  ranges.reserve(boxes.size());
  for (const Box& box : boxes)
    ranges.push_back(range_around(box.lowest_m[axis], box.highest_m[axis]));
  return ranges;
}

}  // namespace

RectangleMap::RectangleMap(Objects objects) : ObjectSet(std::move(objects)) {
  assert(!this->objects().empty());
  const std::vector<Box> boxes = bounds_of(this->objects());
  bounds_ = around(boxes);
  order_ = neighbours_together(boxes, bounds_);
  boxes_.reserve(boxes.size());
  for (const int i : order_) boxes_.push_back(boxes[static_cast<std::size_t>(i)]);
  while (!build()) group_size_ *= 2;
}

// Whether that could be done within a multiple of the objects.
bool RectangleMap::build() {
  group_boxes_.clear();
  if (group_size_ > 1) {
    const std::span<const Box> boxes(boxes_);
    for (std::size_t i = 0; i < boxes.size(); i += group_size_)
      group_boxes_.push_back(around(boxes.subspan(i, std::min(group_size_, boxes.size() - i))));
  }
  const auto& boxes = group_size_ > 1 ? group_boxes_ : boxes_;
  const RankedAxis x = rank_axis(ranges(boxes, 0));
  const RankedAxis y = rank_axis(ranges(boxes, 1));
  constexpr std::size_t kMost = 64;
  auto partition = cut_plane(x, y, kMost * (boxes_.size() + kMost));
  if (!partition) return false;
  tiles_ = link(*partition, x.lines, y.lines);
  lists_ = std::move(partition->lists);
  cells_.emplace(boxes, bounds_);
  lay_tiles();
  return true;
}

void RectangleMap::lay_tiles() {
  tiles_at_.resize(cells_->place(cells_->size() - 1) + 1);
  int number = 0;
  for (const Tile& tile : tiles_.tiles) {
    const auto first = [&](int axis, std::size_t side) {
      return cells_->first_centre(axis, static_cast<double>(tile.border_m[side]));
    };
    const int east = first(0, 1);
    const int north = first(1, 3);
    for (int j = first(1, 2); j < north; ++j)
      for (int i = first(0, 0); i < east; ++i) tiles_at_[cells_->place({i, j})] = number;
    ++number;
  }
}

// Calls visit(object, leave_m) for the objects whose bounds the ray enters before leave_m, in the
// order of the map, until it returns true. It may shorten leave_m to a hit.
template <class Visit>
void RectangleMap::walk(const Ray& ray, ObjectCounts* counts, const Visit& visit) const {
  const SlabRay slabs(ray);
  const auto whole = slabs.within(bounds_);
  if (!whole) return;
  double leave_m = whole->leave_m;
  std::int64_t steps = 0;
  const Course course(tiles_, slabs);
  Stretch here = *whole;
  const glm::dvec2 entry_m(slabs.at_m(0, here.enter_m), slabs.at_m(1, here.enter_m));
  int at = course.tile_at(here.enter_m, tiles_at_[cells_->place(cells_->near(entry_m))], steps);
  for (int patience = kPatience; at != Tile::kEdge; ++steps) {
    const Tile& tile = course.tile(at);
    const Course::Exit exit = course.exit(tile);
    here.leave_m = exit.passing.at_m;
    if (tile.over != Rectangle::kEmpty && meet(slabs, tile.over, here, leave_m, visit)) break;
    if (exit.passing.at_m > leave_m) break;
    here.enter_m = exit.passing.at_m;
    if (--patience > 0) {
      at = course.beyond(tile, exit.side, exit.passing);
      continue;
    }
    patience = kPatience;
    CellWalk cells(*cells_, slabs, here.enter_m);
    const auto next = cells.next(leave_m);
    if (!next) break;
    if (next->enter_m > here.enter_m) {
      here.enter_m = next->enter_m;
      at = course.tile_at(here.enter_m, tiles_at_[cells.cell()], steps);
    } else {
      at = course.beyond(tile, exit.side, exit.passing);
    }
  }
  if (counts != nullptr) counts->steps += steps;
}

// Visits those over a tile that the ray enters here, in the order in which it does; the others are
// met elsewhere.
template <class Visit>
bool RectangleMap::meet(const SlabRay& slabs, int over, const Stretch& here, double& leave_m,
                        const Visit& visit) const {
  const auto& boxes = group_size_ > 1 ? group_boxes_ : boxes_;
  const std::span<const int> list = over >= 0 ? std::span<const int>(&over, 1) : lists_[-2 - over];
  return visit_in_order(
      slabs, list, here, leave_m,
      [&](int group) -> const Box& { return boxes[static_cast<std::size_t>(group)]; },
      [](int group) { return group; },
      [&](int group) { return meet(slabs, group, leave_m, visit); });
}

template <class Visit>
bool RectangleMap::meet(const SlabRay& slabs, int group, double& leave_m,
                        const Visit& visit) const {
  const auto i = static_cast<std::size_t>(group);
  if (group_size_ == 1) return visit(order_[i], leave_m);
  const std::size_t end = std::min(boxes_.size(), (i + 1) * group_size_);
  for (std::size_t member = i * group_size_; member < end; ++member)
    if (slabs.within(boxes_[member], 0, leave_m) && visit(order_[member], leave_m)) return true;
  return false;
}

std::optional<ObjectHit> RectangleMap::first_hit(const Ray& ray, ObjectCounts* counts) const {
  std::optional<ObjectHit> nearest;
  std::int64_t tests = 0;
  walk(ray, counts, [&](int object, double& leave_m) {
    ++tests;
    const auto hit = objects()[static_cast<std::size_t>(object)]->first_hit(ray);
    if (!hit) return false;
    if (comes_before(*hit, object, nearest)) nearest = ObjectHit{*hit, object};
    leave_m = nearest->surface.distance_m;
    return false;
  });
  if (counts != nullptr) counts->tests += tests;
  return nearest;
}

bool RectangleMap::stops(const Ray& ray, ObjectCounts* counts) const {
  bool found = false;
  std::int64_t tests = 0;
  walk(ray, counts, [&](int object, double&) {
    ++tests;
    found = objects()[static_cast<std::size_t>(object)]->stops(ray);
    return found;
  });
  if (counts != nullptr) counts->tests += tests;
  return found;
}

std::size_t RectangleMap::empty_rectangles() const {
  return static_cast<std::size_t>(std::ranges::count(tiles_.tiles, Rectangle::kEmpty, &Tile::over));
}

std::size_t RectangleMap::bytes() const {
  const auto of = [](const auto& vector) { return vector.capacity() * sizeof(vector[0]); };
  return of(order_) + of(boxes_) + of(group_boxes_) + lists_.bytes() + of(tiles_.tiles) +
         of(tiles_.neighbours) + of(tiles_at_) + cells_->bytes();
}

}  // namespace terrview

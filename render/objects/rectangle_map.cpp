#include "render/objects/rectangle_map.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>

#include <glm/common.hpp>

#include "render/objects/rectangle_course.h"
#include "render/objects/rectangle_ranks.h"

namespace terrview {
namespace {

Box around(std::span<const Box> boxes) {
  Box sum = boxes.front();
  for (const Box& box : boxes)
    sum = {glm::min(sum.lowest_m, box.lowest_m), glm::max(sum.highest_m, box.highest_m)};
  return sum;
}

// The bits of two coordinates by turns: what is near in number is near in the plane.
std::uint64_t interleaved(std::uint32_t x, std::uint32_t y) {
  const auto spread = [](std::uint64_t v) {
    v = (v | v << 16) & 0x0000FFFF0000FFFF;
    v = (v | v << 8) & 0x00FF00FF00FF00FF;
    v = (v | v << 4) & 0x0F0F0F0F0F0F0F0F;
    v = (v | v << 2) & 0x3333333333333333;
    return (v | v << 1) & 0x5555555555555555;
  };
  return spread(x) | spread(y) << 1;
}

std::vector<int> neighbours_together(const std::vector<Box>& boxes, const Box& bounds) {
  std::vector<std::pair<std::uint64_t, int>> places;
  for (const Box& box : boxes) {
    const auto place = [&](int axis) {
      const double low_m = bounds.lowest_m[axis];
      const double middle_m = box.lowest_m[axis] / 2 + box.highest_m[axis] / 2;
      const double share = (middle_m / 2 - low_m / 2) / (bounds.highest_m[axis] / 2 - low_m / 2);
      constexpr double kMost = 4294967295.0;
      return share > 0 ? static_cast<std::uint32_t>(std::min(share, 1.0) * kMost) : 0U;
    };
    places.emplace_back(interleaved(place(0), place(1)), static_cast<int>(places.size()));
  }
  std::sort(places.begin(), places.end());
  std::vector<int> order;
  for (const auto& [place, i] : places) order.push_back(i);
  return order;
}

std::vector<Range> ranges(const std::vector<Box>& boxes, int axis) {
  std::vector<Range> ranges;
  ranges.reserve(boxes.size());
  for (const Box& box : boxes)
    ranges.push_back(range_around(box.lowest_m[axis], box.highest_m[axis]));
  return ranges;
}

}  // namespace

RectangleMap::RectangleMap(Objects objects)
    : ObjectSet(std::move(objects)), order_(this->objects().size()) {
  assert(!this->objects().empty());
  std::iota(order_.begin(), order_.end(), 0);
  boxes_.reserve(order_.size());
  for (const auto& object : this->objects()) boxes_.push_back(object->bounds());
  bounds_ = around(boxes_);
  if (build()) return;
  order_ = neighbours_together(boxes_, bounds_);
  std::vector<Box> sorted;
  for (const int i : order_) sorted.push_back(boxes_[static_cast<std::size_t>(i)]);
  boxes_ = std::move(sorted);
  do {
    group_size_ *= 2;
  } while (!build());
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
  constexpr std::size_t kMost = 32;
  auto partition = cut_plane(x, y, kMost * (boxes_.size() + kMost));
  if (!partition) return false;
  lists_ = std::move(partition->lists);
  tiles_ = link(partition->rectangles, x.lines, y.lines);
  cells_.emplace(boxes, bounds_, tiles_.tiles);
  return true;
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
  CellWalk cells(*cells_, slabs, whole->enter_m);
  int at = Tile::kEdge;
  double walked_m = 0;
  bool done = false;
  while (!done) {
    const auto stretch = cells.next(leave_m);
    if (!stretch) break;
    if (at == Tile::kEdge || stretch->enter_m > walked_m)
      at = course.tile_at(stretch->enter_m, cells.tile(), steps);
    walked_m = stretch->leave_m;
    for (Stretch here = *stretch;; here.enter_m = here.leave_m, ++steps) {
      const Tile& tile = course.tile(at);
      const Course::Exit exit = course.exit(tile);
      here.leave_m = std::min(exit.passing.at_m, walked_m);
      done = tile.list != Rectangle::kEmpty && meet(slabs, tile.list, here, leave_m, visit);
      if (done || exit.passing.at_m > std::min(walked_m, leave_m)) break;
      at = course.beyond(tile, exit.side, exit.passing);
      done = at == Tile::kEdge;
      if (done) break;
    }
  }
  if (counts != nullptr) counts->steps += steps;
}

// Visits those of a list that the ray enters here; the others are met elsewhere.
template <class Visit>
bool RectangleMap::meet(const SlabRay& slabs, int list, const Stretch& here, double& leave_m,
                        const Visit& visit) const {
  const auto& boxes = group_size_ > 1 ? group_boxes_ : boxes_;
  for (const int group : lists_[list]) {
    const auto i = static_cast<std::size_t>(group);
    const auto stretch = slabs.within(boxes[i], 0, leave_m);
    if (!stretch || stretch->enter_m < here.enter_m || stretch->enter_m > here.leave_m) continue;
    const std::size_t end = std::min(boxes_.size(), (i + 1) * group_size_);
    for (std::size_t member = i * group_size_; member < end; ++member) {
      if (group_size_ > 1 && !slabs.within(boxes_[member], 0, leave_m)) continue;
      if (visit(order_[member], leave_m)) return true;
    }
  }
  return false;
}

std::optional<ObjectHit> RectangleMap::first_hit(const Ray& ray, ObjectCounts* counts) const {
  std::optional<ObjectHit> nearest;
  std::int64_t tests = 0;
  walk(ray, counts, [&](int object, double& leave_m) {
    ++tests;
    const auto hit = objects()[static_cast<std::size_t>(object)]->first_hit(ray);
    if (!hit) return false;
    const bool is_nearer =
        !nearest || hit->distance_m < nearest->surface.distance_m ||
        (hit->distance_m == nearest->surface.distance_m && object < nearest->object);
    if (is_nearer) nearest = ObjectHit{*hit, object};
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
  return static_cast<std::size_t>(std::ranges::count(tiles_.tiles, Rectangle::kEmpty, &Tile::list));
}

std::size_t RectangleMap::bytes() const {
  const auto of = [](const auto& vector) { return vector.capacity() * sizeof(vector[0]); };
  return of(order_) + of(boxes_) + of(group_boxes_) + lists_.bytes() + of(tiles_.tiles) +
         of(tiles_.neighbours) + cells_->bytes();
}

}  // namespace terrview

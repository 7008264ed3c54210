#include "render/objects/rectangle_map.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

#include <glm/common.hpp>

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

std::vector<int> neighbours_together(const std::vector<Box>& boxes, const Box& bounds,
                                     const std::array<int, 2>& axes) {
  std::vector<std::pair<std::uint64_t, int>> places;
  for (const Box& box : boxes) {
    const auto place = [&](int axis) {
      const double low_m = bounds.lowest_m[axis];
      const double middle_m = box.lowest_m[axis] / 2 + box.highest_m[axis] / 2;
      const double share = (middle_m / 2 - low_m / 2) / (bounds.highest_m[axis] / 2 - low_m / 2);
      constexpr double kMost = 4294967295.0;
      return share > 0 ? static_cast<std::uint32_t>(std::min(share, 1.0) * kMost) : 0U;
    };
    places.emplace_back(interleaved(place(axes[0]), place(axes[1])),
                        static_cast<int>(places.size()));
  }
  std::sort(places.begin(), places.end());
  std::vector<int> order;
  for (const auto& [place, i] : places) order.push_back(i);
  return order;
}

}  // namespace

RectangleMap::RectangleMap(Objects objects, int along)
    : ObjectSet(std::move(objects)), order_(this->objects().size()) {
  assert(!this->objects().empty());
  std::iota(order_.begin(), order_.end(), 0);
  for (const auto& object : this->objects()) boxes_.push_back(object->bounds());
  bounds_ = around(boxes_);
  const std::array<int, 2> axes{along == 0 ? 1 : 0, along == 2 ? 1 : 2};
  if (build(axes)) return;
  order_ = neighbours_together(boxes_, bounds_, axes);
  std::vector<Box> sorted;
  for (const int i : order_) sorted.push_back(boxes_[static_cast<std::size_t>(i)]);
  boxes_ = std::move(sorted);
  do {
    group_size_ *= 2;
  } while (!build(axes));
}

// Whether that could be done within a multiple of the objects.
bool RectangleMap::build(const std::array<int, 2>& axes) {
  group_boxes_.clear();
  if (group_size_ > 1) {
    const std::span<const Box> boxes(boxes_);
    for (std::size_t i = 0; i < boxes.size(); i += group_size_)
      group_boxes_.push_back(around(boxes.subspan(i, std::min(group_size_, boxes.size() - i))));
  }
  const auto& boxes = group_size_ > 1 ? group_boxes_ : boxes_;
  RankedAxis x = rank_axis(boxes, axes[0]);
  RankedAxis y = rank_axis(boxes, axes[1]);
  constexpr std::size_t kMost = 32;
  auto partition = cut_plane(x, y, kMost * (boxes_.size() + kMost));
  if (!partition) return false;
  std::array<Lines, 2> lines{std::move(x.lines), std::move(y.lines)};
  Tiles tiles = link(partition->rectangles);
  RectangleIndex index(tiles.tiles, lines);
  lists_ = std::move(partition->lists);
  plane_ = {axes, std::move(lines), std::move(tiles), std::move(index)};
  return true;
}

// Calls visit(object, leave_m) for the objects whose bounds the ray pierces before leave_m, in the
// order of the map, until it returns true. It may shorten leave_m to a hit.
template <class Visit>
void RectangleMap::walk(const Ray& ray, ObjectCounts* counts, const Visit& visit) const {
  const SlabRay slabs(ray);
  const auto stretch = slabs.within(bounds_);
  if (!stretch) return;
  double leave_m = stretch->leave_m;
  double entered_m = -std::numeric_limits<double>::infinity();
  const Course course(*plane_, slabs);
  std::int64_t steps = 0;
  for (int at = course.tile_at(stretch->enter_m, steps); at != Course::kEdge; ++steps) {
    const Tile& tile = course.tile(at);
    if (tile.list != Rectangle::kEmpty && meet(slabs, tile.list, entered_m, leave_m, visit)) break;
    const Course::Exit exit = course.exit(tile);
    entered_m = exit.passing.at_m;
    if (entered_m > leave_m) break;
    at = course.beyond(tile, exit.side, exit.passing);
  }
  if (counts != nullptr) counts->steps += steps;
}

template <class Visit>
bool RectangleMap::meet(const SlabRay& slabs, int list, double entered_m, double& leave_m,
                        const Visit& visit) const {
  const auto& boxes = group_size_ > 1 ? group_boxes_ : boxes_;
  for (const int group : lists_[list]) {
    const auto i = static_cast<std::size_t>(group);
    const double near_m = std::max(
        std::max(-std::numeric_limits<double>::infinity(), slabs.near_m(plane_->axes[0], boxes[i])),
        slabs.near_m(plane_->axes[1], boxes[i]));
    if (near_m < entered_m) continue;  // met where it was entered
    if (!slabs.within(boxes[i], 0, leave_m)) continue;
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
  return static_cast<std::size_t>(
      std::ranges::count(plane_->tiles.tiles, Rectangle::kEmpty, &Tile::list));
}

std::size_t RectangleMap::bytes() const {
  const auto of = [](const auto& vector) { return vector.capacity() * sizeof(vector[0]); };
  return of(order_) + of(boxes_) + of(group_boxes_) + lists_.bytes() + plane_->lines[0].bytes() +
         plane_->lines[1].bytes() + of(plane_->tiles.tiles) + of(plane_->tiles.neighbours) +
         plane_->index.bytes();
}

}  // namespace terrview

#include "render/objects/cell_map.h"

#include <cstdint>
#include <span>
#include <utility>

#include "render/objects/entry_order.h"
#include "render/objects/object_bounds.h"

namespace terrview {

CellMap::CellMap(Objects objects) : ObjectSet(std::move(objects)) {
  std::vector<Box> boxes;
  std::vector<Entry> entries;
  boxes.reserve(this->objects().size());
  entries.reserve(this->objects().size());
  for (const auto& object : this->objects()) {
    const auto& [low_m, high_m] = object->bounds();
    Entry entry{{}, static_cast<int>(entries.size())};
    for (int axis = 0; axis < 3; ++axis)
      entry.range[static_cast<std::size_t>(axis)] = range_around(low_m[axis], high_m[axis]);
    entries.push_back(entry);
    boxes.push_back(entry.box());
  }
  bounds_ = around(boxes);
  cells_.emplace(boxes, bounds_);
  ends_.resize(cells_->place(cells_->size() - 1) + 2);
  for (const Box& box : boxes) cells_->over(box, [&](std::size_t cell) { ++ends_[cell]; });
  for (std::size_t i = 1; i < ends_.size(); ++i) ends_[i] += ends_[i - 1];
  lists_.resize(static_cast<std::size_t>(ends_.back()));
  for (std::size_t i = boxes.size(); i-- > 0;)
    cells_->over(boxes[i], [&](std::size_t cell) {
      lists_[static_cast<std::size_t>(--ends_[cell])] = entries[i];
    });
}

// Calls visit(object, leave_m) for the objects whose bounds the ray enters before leave_m, cell
// after cell, until it returns true. It may shorten leave_m to a hit.
template <class Visit>
void CellMap::walk(const Ray& ray, ObjectCounts* counts, const Visit& visit) const {
  const SlabRay slabs(ray);
  const auto whole = slabs.within(bounds_);
  if (!whole) return;
  double leave_m = whole->leave_m;
  std::int64_t steps = 0;
  std::int64_t tests = 0;
  CellWalk cells(*cells_, slabs, whole->enter_m);
  const auto meet = [&](int object) {
    ++tests;
    return visit(object, leave_m);
  };
  while (const auto here = cells.next(leave_m)) {
    ++steps;
    const auto begin = static_cast<std::size_t>(ends_[cells.cell()]);
    const auto end = static_cast<std::size_t>(ends_[cells.cell() + 1]);
    const std::span<const Entry> list(lists_.data() + begin, end - begin);
    if (visit_in_order(
            slabs, list, *here, leave_m, [](const Entry& it) { return it.box(); },
            [](const Entry& it) { return it.object; }, meet))
      break;
  }
  if (counts != nullptr) *counts += {tests, steps};
}

std::optional<ObjectHit> CellMap::first_hit(const Ray& ray, ObjectCounts* counts) const {
  std::optional<ObjectHit> nearest;
  walk(ray, counts, [&](int object, double& leave_m) {
    const auto hit = objects()[static_cast<std::size_t>(object)]->first_hit(ray);
    if (!hit || !comes_before(*hit, object, nearest)) return false;
    nearest = ObjectHit{*hit, object};
    leave_m = hit->distance_m;
    return false;
  });
  return nearest;
}

bool CellMap::stops(const Ray& ray, ObjectCounts* counts) const {
  bool found = false;
  walk(ray, counts, [&](int object, double&) {
    return found = objects()[static_cast<std::size_t>(object)]->stops(ray);
  });
  return found;
}

std::size_t CellMap::bytes() const {
  return cells_->bytes() + ends_.capacity() * sizeof(int) + lists_.capacity() * sizeof(Entry);
}

}  // namespace terrview

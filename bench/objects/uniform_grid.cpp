#include "bench/objects/uniform_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <glm/common.hpp>

namespace terrview {

UniformGrid::UniformGrid(Objects objects) : ObjectSet(std::move(objects)) {
  for (const auto& object : this->objects()) boxes_.push_back(object->bounds());
  bounds_ = boxes_.front();
  for (const Box& box : boxes_)
    bounds_ = {glm::min(bounds_.lowest_m, box.lowest_m),
               glm::max(bounds_.highest_m, box.highest_m)};
  const glm::dvec3 extent_m = bounds_.highest_m - bounds_.lowest_m;
  cell_m_ = std::sqrt(extent_m.x * extent_m.y / static_cast<double>(boxes_.size()));
  for (int axis = 0; axis < 2; ++axis)
    size_[axis] = std::max(1, static_cast<int>(std::ceil(extent_m[axis] / cell_m_)));
  const auto for_each_cell = [&](const Box& box, const auto& visit) {
    for (int y = cell(1, box.lowest_m.y); y <= cell(1, box.highest_m.y); ++y)
      for (int x = cell(0, box.lowest_m.x); x <= cell(0, box.highest_m.x); ++x)
        visit(static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.x) +
              static_cast<std::size_t>(x));
  };
  ends_.resize(static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y) + 1);
  for (const Box& box : boxes_) for_each_cell(box, [&](std::size_t i) { ++ends_[i]; });
  for (std::size_t i = 1; i < ends_.size(); ++i) ends_[i] += ends_[i - 1];
  lists_.resize(static_cast<std::size_t>(ends_.back()));
  for (std::size_t i = boxes_.size(); i-- > 0;)
    for_each_cell(boxes_[i], [&](std::size_t at) {
      lists_[static_cast<std::size_t>(--ends_[at])] = static_cast<int>(i);
    });
}

int UniformGrid::cell(int axis, double at_m) const {
  return std::clamp(static_cast<int>((at_m - bounds_.lowest_m[axis]) / cell_m_), 0,
                    size_[axis] - 1);
}

template <class Visit>
void UniformGrid::walk(const Ray& ray, ObjectCounts* counts, const Visit& visit) const {
  const SlabRay slabs(ray);
  const auto stretch = slabs.within(bounds_);
  if (!stretch) return;
  double leave_m = stretch->leave_m;
  glm::ivec2 at;
  glm::ivec2 step;
  glm::dvec2 next_m;
  glm::dvec2 pace_m;
  for (int axis = 0; axis < 2; ++axis) {
    at[axis] = cell(axis, slabs.at_m(axis, stretch->enter_m));
    step[axis] = slabs.backward(axis) ? -1 : 1;
    const double low_m = bounds_.lowest_m[axis];
    const int ahead = at[axis] + (step[axis] > 0 ? 1 : 0);
    next_m[axis] = slabs.distance_m(axis, low_m + ahead * cell_m_);
    pace_m[axis] =
        std::abs(slabs.distance_m(axis, low_m + cell_m_) - slabs.distance_m(axis, low_m));
    if (ray.direction[axis] == 0) next_m[axis] = pace_m[axis] = SlabRay::kFarthest_m;
  }
  std::array<int, 8> met;
  met.fill(-1);
  std::size_t meetings = 0;
  for (;;) {
    const auto i = static_cast<std::size_t>(at.y) * static_cast<std::size_t>(size_.x) +
                   static_cast<std::size_t>(at.x);
    if (counts != nullptr) ++counts->steps;
    for (int k = ends_[i]; k < ends_[i + 1]; ++k) {
      const int object = lists_[static_cast<std::size_t>(k)];
      if (!slabs.within(boxes_[static_cast<std::size_t>(object)], 0, leave_m)) continue;
      if (std::ranges::find(met, object) != met.end()) continue;
      met[meetings++ % met.size()] = object;
      if (counts != nullptr) ++counts->tests;
      if (visit(object, leave_m)) return;
    }
    const int axis = next_m.x < next_m.y ? 0 : 1;
    if (next_m[axis] > leave_m) return;
    at[axis] += step[axis];
    if (at[axis] < 0 || at[axis] >= size_[axis]) return;
    next_m[axis] += pace_m[axis];
  }
}

std::optional<ObjectHit> UniformGrid::first_hit(const Ray& ray, ObjectCounts* counts) const {
  std::optional<ObjectHit> nearest;
  walk(ray, counts, [&](int object, double& leave_m) {
    const auto hit = objects()[static_cast<std::size_t>(object)]->first_hit(ray);
    if (!hit) return false;
    if (!nearest || hit->distance_m < nearest->surface.distance_m)
      nearest = ObjectHit{*hit, object};
    leave_m = nearest->surface.distance_m;
    return false;
  });
  return nearest;
}

bool UniformGrid::stops(const Ray& ray, ObjectCounts* counts) const {
  bool found = false;
  walk(ray, counts, [&](int object, double&) {
    return found = objects()[static_cast<std::size_t>(object)]->stops(ray);
  });
  return found;
}

std::size_t UniformGrid::bytes() const {
  return boxes_.size() * sizeof(Box) + (ends_.size() + lists_.size()) * sizeof(int);
}

}  // namespace terrview

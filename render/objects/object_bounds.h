// The bounds of many objects.
#pragma once

#include <span>
#include <vector>

#include <glm/common.hpp>

#include "render/objects/object_set.h"

namespace terrview {

[[nodiscard]] inline std::vector<Box> bounds_of(const Objects& objects) {
  std::vector<Box> boxes;
  boxes.reserve(objects.size());
  for (const auto& object : objects) boxes.push_back(object->bounds());
  return boxes;
}

// Of at least one.
[[nodiscard]] inline Box around(std::span<const Box> boxes) {
  Box sum = boxes.front();
  for (const Box& box : boxes)
    sum = {glm::min(sum.lowest_m, box.lowest_m), glm::max(sum.highest_m, box.highest_m)};
  return sum;
}

}  // namespace terrview

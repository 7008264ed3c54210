// The bounds of many objects.
#pragma once

#include <array>
#include <cstddef>
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

[[nodiscard]] inline std::array<glm::dvec3, 8> corners_of(const Box& box) {
  std::array<glm::dvec3, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i)
    corners[i] = {i & 1U ? box.highest_m.x : box.lowest_m.x,
                  i & 2U ? box.highest_m.y : box.lowest_m.y,
                  i & 4U ? box.highest_m.z : box.lowest_m.z};
  return corners;
}

}  // namespace terrview

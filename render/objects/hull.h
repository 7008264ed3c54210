// The shape of a footprint, as far as a roof cares.
#pragma once

#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace terrview {

// The corners of the convex hull, anticlockwise, none of them on the line between its neighbours.
[[nodiscard]] std::vector<glm::dvec2> convex_hull(std::span<const glm::dvec2> points);

// A rectangle at an angle.
struct OrientedRectangle {
  glm::dvec2 middle{0, 0};
  glm::dvec2 along{1, 0};  // unit length, the way of the longer sides
  double half_length = 0;
  double half_width = 0;
};

// The smallest rectangle around `hull` with a side along one of its edges. Of a hull with hundreds
// of edges only some are tried.
[[nodiscard]] OrientedRectangle enclosing_rectangle(std::span<const glm::dvec2> hull);

}  // namespace terrview

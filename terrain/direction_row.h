// The directions of a row of rays of the view frame, of any length, in vectors.
#pragma once

#include <span>

#include <glm/vec3.hpp>

namespace terrview {

// Direction i is (first + right * ((from + i - middle) * step)) + above, in this order.
struct DirectionRow {
  glm::dvec3 first;
  glm::dvec3 right;
  glm::dvec3 above;
  double from;    // in columns
  double middle;  // in columns
  double step;    // of `right`, a column
};

struct DirectionSpans {
  std::span<double> x, y, z;  // all as long
};

void lay(const DirectionRow& row, const DirectionSpans& directions);

}  // namespace terrview

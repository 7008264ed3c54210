// Crossings with the bound of their error, for those who write solids.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "render/objects/ray_range.h"
#include "render/objects/solids/solid.h"

namespace terrview {

// What a sum of some thirty products loses, as a share of the numbers in it. No solid takes more to
// compare a point of a line with its surface.
inline constexpr double kLostDigits = 32 * std::numeric_limits<double>::epsilon();

[[nodiscard]] inline double sum_of_sizes(const glm::dvec3& v) {
  return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

// The crossing at t of a surface of that unit normal; `size_m`: how large the coordinates of the
// surface are. A point that is off by p moves the crossing by p / |normal . direction|.
[[nodiscard]] inline Crossing crossing_at(const Line& line, double t, const glm::dvec3& normal,
                                          double size_m, bool enters) {
  if (std::isinf(t)) return {t, 0, glm::dvec3(0), 0, enters};
  const double off_m = line.origin_error_m + std::abs(t) * line.direction_error +
                       kLostDigits * (sum_of_sizes(line.origin_m) +
                                      std::abs(t) * sum_of_sizes(line.direction) + size_m);
  const double pace = std::abs(glm::dot(normal, line.direction));
  return {t, std::min(off_m / pace, std::numeric_limits<double>::max()), normal, 0, enters};
}

// Appends the two ends of the range of a convex solid, of which normal_at(t, surface) is the unit
// normal.
template <class NormalAt>
void append_range(const Line& line, const RayRange& range, double size_m, const NormalAt& normal_at,
                  Crossings& crossings) {
  if (range.is_empty()) return;
  crossings.push_back(
      crossing_at(line, range.from, normal_at(range.from, range.enters_by), size_m, true));
  crossings.push_back(
      crossing_at(line, range.to, normal_at(range.to, range.leaves_by), size_m, false));
}

// The t at which the line is nearest to a point.
[[nodiscard]] inline double nearest_to(const Line& line, const glm::dvec3& point_m) {
  return -glm::dot(line.origin_m - point_m, line.direction) /
         glm::dot(line.direction, line.direction);
}

}  // namespace terrview

// Where a ray's line is inside of something convex.
#pragma once

#include <limits>

#include <glm/vec3.hpp>

namespace terrview {

// A half space: dot(normal, point) <= offset.
struct HalfSpace {
  glm::dvec3 normal;
  double offset;
};

// From where the line enters to where it leaves, by the surfaces numbered `enters_by` and
// `leaves_by`; empty where it begins no sooner than it ends.
struct RayRange {
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();
  int enters_by = -1;
  int leaves_by = -1;

  [[nodiscard]] bool is_empty() const { return !(from < to); }

  // Keeps the part of the line origin + t * direction that is in `half`.
  void clip(const HalfSpace& half, const glm::dvec3& origin, const glm::dvec3& direction,
            int surface) {
    const double towards =
        half.normal.x * direction.x + half.normal.y * direction.y + half.normal.z * direction.z;
    const double room = half.offset - (half.normal.x * origin.x + half.normal.y * origin.y +
                                       half.normal.z * origin.z);
    if (towards == 0) {
      if (room < 0) to = from;
      return;
    }
    const double t = room / towards;
    if (towards > 0 && t < to) {
      to = t;
      leaves_by = surface;
    } else if (towards < 0 && t > from) {
      from = t;
      enters_by = surface;
    }
  }
};

}  // namespace terrview

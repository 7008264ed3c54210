// The stretch of a ray within a box.
//
// Everything in render/objects/ that compares a ray with a coordinate does it through
// SlabRay::distance_m(), which is monotonic in the coordinate: no part can decide a close case
// otherwise than another, so a search needs no tolerance (Ize, JCGT 2(2), 2013, is the
// alternative).
#pragma once

#include <algorithm>
#include <limits>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "render/objects/object.h"

namespace terrview {

// Distances along a ray, enter_m <= leave_m.
struct Stretch {
  double enter_m;
  double leave_m;
};

class SlabRay {
 public:
  static constexpr double kFarthest_m = std::numeric_limits<double>::max();

  explicit SlabRay(const Ray& ray)
      : origin_m_(ray.origin_m), length_m_(std::min(ray.length_m, kFarthest_m)) {
    const double length = glm::length(ray.direction);
    for (int axis = 0; axis < 3; ++axis) {
      const double d = ray.direction[axis];
      backward_[axis] = d < 0;
      pace_[axis] = d == 0 ? std::numeric_limits<double>::infinity() : length / d;
      rate_[axis] = d / length;
    }
  }

  // Where the ray passes the plane axis = at_m: infinitely far off where it is parallel to it, NaN
  // where it lies in it.
  [[nodiscard]] double distance_m(int axis, double at_m) const {
    return (at_m - origin_m_[axis]) * pace_[axis];
  }

  // The coordinate at a distance.
  [[nodiscard]] double at_m(int axis, double distance_m) const {
    return origin_m_[axis] + distance_m * rate_[axis];
  }

  [[nodiscard]] bool backward(int axis) const { return backward_[axis]; }
  [[nodiscard]] double length_m() const { return length_m_; }

  // Where the ray enters the slab between the two sides of `box`; a ray in its plane always did.
  [[nodiscard]] double near_m(int axis, const Box& box) const {
    return distance_m(axis, (backward_[axis] ? box.highest_m : box.lowest_m)[axis]);
  }
  [[nodiscard]] double far_m(int axis, const Box& box) const {
    return distance_m(axis, (backward_[axis] ? box.lowest_m : box.highest_m)[axis]);
  }

  // The part of [from_m, to_m] within the closed box.
  [[nodiscard]] std::optional<Stretch> within(const Box& box, double from_m, double to_m) const {
    for (int axis = 0; axis < 3; ++axis) {
      // In this order, a NaN changes nothing.
      from_m = std::max(from_m, near_m(axis, box));
      to_m = std::min(to_m, far_m(axis, box));
    }
    if (from_m > to_m) return std::nullopt;
    return Stretch{from_m, to_m};
  }
  [[nodiscard]] std::optional<Stretch> within(const Box& box) const {
    return within(box, 0, length_m_);
  }

 private:
  glm::dvec3 origin_m_;
  glm::dvec3 pace_;  // distance per coordinate
  glm::dvec3 rate_;  // coordinate per distance
  double length_m_;
  glm::bvec3 backward_;
};

}  // namespace terrview

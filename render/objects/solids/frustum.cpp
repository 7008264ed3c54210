#include "render/objects/solids/frustum.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "render/objects/solids/check_size.h"
#include "render/objects/solids/crossing.h"

namespace terrview {
namespace {

enum Surface { kSide, kBase, kTop };

}  // namespace

Frustum::Frustum(const FrustumShape& shape)
    : shape_(shape), taper_((shape.top_radius_m - shape.base_radius_m) / shape.height_m) {
  check_size("cone", "height", shape.height_m);
  check_size("cone", "base radius", shape.base_radius_m, /*may_be_zero=*/true);
  check_size("cone", "top radius", shape.top_radius_m, /*may_be_zero=*/true);
  check_size("cone", "larger radius", std::max(shape.base_radius_m, shape.top_radius_m));
}

Box Frustum::bounds() const {
  const double radius_m = std::max(shape_.base_radius_m, shape_.top_radius_m);
  return {{-radius_m, -radius_m, 0}, {radius_m, radius_m, shape_.height_m}};
}

// a t^2 + 2 b t + c about a point of the line.
struct Frustum::Quadratic {
  double a;
  double b;
  double c;

  Quadratic(const Frustum& of, const glm::dvec3& from_m, const glm::dvec3& way) {
    const double radius_m = of.shape_.base_radius_m + of.taper_ * from_m.z;
    const double off_axis_m = glm::length(glm::dvec2(from_m));
    const double growth = of.taper_ * way.z;
    a = way.x * way.x + way.y * way.y - growth * growth;
    b = from_m.x * way.x + from_m.y * way.y - radius_m * growth;
    c = (off_axis_m - radius_m) * (off_axis_m + radius_m);
  }

  // The roots, the lower first, where a is not 0; the same twice where rounding leaves none.
  [[nodiscard]] std::pair<double, double> roots() const {
    const double far = -(b + std::copysign(std::sqrt(std::max(b * b - a * c, 0.0)), b));
    if (far == 0) return {0, 0};
    return std::minmax({far / a, c / far});
  }
};

// Within the side extended up and down, and where that is a double cone, within its half.
RayRange Frustum::within_side(const Line& line) const {
  // About the middle of the solid, so that a far origin costs no digits.
  const double middle = nearest_to(line, {0, 0, shape_.height_m / 2});
  const glm::dvec3 from_m = line.origin_m + middle * line.direction;
  const Quadratic at_middle(*this, from_m, line.direction);
  RayRange range;
  if (at_middle.a == 0) {  // along the side
    if (at_middle.b == 0 && at_middle.c > 0) range.to = range.from;
    if (at_middle.b < 0) range = {middle - at_middle.c / (2 * at_middle.b), range.to, kSide, -1};
    if (at_middle.b > 0) range = {range.from, middle - at_middle.c / (2 * at_middle.b), -1, kSide};
    return range;
  }
  if (at_middle.a > 0 && at_middle.b * at_middle.b <= at_middle.a * at_middle.c) {
    range.to = range.from;
    return range;
  }
  const auto [low, high] = at_middle.roots();
  // One step of Newton's takes what the discriminant lost.
  const double reach = (high - low) / 8;
  const auto polished = [&](double t) {
    const Quadratic there(*this, from_m + t * line.direction, line.direction);
    const double step = there.c / (2 * there.b);
    return middle + (std::abs(step) < reach ? t - step : t);
  };
  if (at_middle.a > 0) return {polished(low), polished(high), kSide, kSide};
  // Steeper than the side: within it from or up to one root, within its mirror image from the
  // other.
  if (taper_ * line.direction.z > 0) return {polished(high), range.to, kSide, -1};
  return {range.from, polished(low), -1, kSide};
}

glm::dvec3 Frustum::side_normal(const glm::dvec3& at_m) const {
  const double off_axis_m = glm::length(glm::dvec2(at_m));
  if (off_axis_m == 0) return {0, 0, taper_ > 0 ? -1 : 1};
  return glm::normalize(glm::dvec3(at_m.x / off_axis_m, at_m.y / off_axis_m, -taper_));
}

void Frustum::append_crossings(const Line& line, Crossings& crossings) const {
  RayRange range = within_side(line);
  range.clip({{0, 0, -1}, 0}, line.origin_m, line.direction, kBase);
  range.clip({{0, 0, 1}, shape_.height_m}, line.origin_m, line.direction, kTop);
  const auto normal_at = [&](double t, int surface) {
    if (surface != kSide) return glm::dvec3(0, 0, surface == kBase ? -1 : 1);
    return side_normal(line.origin_m + t * line.direction);
  };
  const double size_m = shape_.height_m + shape_.base_radius_m + shape_.top_radius_m;
  append_range(line, range, size_m, normal_at, crossings);
}

}  // namespace terrview

#include "render/objects/crown.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace terrview {
namespace {

enum Surface { kEllipsoid, kCylinder, kTop, kBottom };

// Where the line is inside of the unit ball.
RayRange in_unit_ball(const glm::dvec3& from, const glm::dvec3& way, int surface) {
  RayRange range;
  const double way2 = glm::dot(way, way);
  const double nearest = way2 > 0 ? -glm::dot(from, way) / way2 : 0;
  const glm::dvec3 foot = from + nearest * way;
  const double room = 1 - glm::dot(foot, foot);
  if (room <= 0) {
    range.to = range.from;
  } else if (way2 > 0) {
    const double half = std::sqrt(room / way2);
    range = {nearest - half, nearest + half, surface, surface};
  }
  return range;
}

}  // namespace

// A ray in the plumb frame, from the tree's middle, its parameter in metres of the view frame.
struct Crown::Line {
  glm::dvec3 origin_m;
  glm::dvec3 direction;

  Line(const LevelPlane& level, const Ray& ray)
      : origin_m(level.point(ray.origin_m) - glm::dvec3(level.middle_m, 0)),
        direction(level.direction(glm::normalize(ray.direction))) {}
};

Box Crown::bounds() const {
  constexpr double kRounding = 1e-12;
  const double radius_m = std::max(shape_.radius_m, shape_.trunk_radius_m);
  const double tilt_m =
      radius_m * (std::abs(shape_.level.slope.x) + std::abs(shape_.level.slope.y));
  const glm::dvec3 middle(shape_.level.middle_m, shape_.level.z_m);
  Box box{
      middle + glm::dvec3(-radius_m, -radius_m, std::min(shape_.foot_m, shape_.bottom_m) - tilt_m),
      middle + glm::dvec3(radius_m, radius_m, shape_.top_m + tilt_m)};
  const double slack_m = kRounding * (glm::length(box.lowest_m) + glm::length(box.highest_m));
  box.lowest_m -= slack_m;
  box.highest_m += slack_m;
  return box;
}

RayRange Crown::in_leaves(const Line& line) const {
  const double half_m = (shape_.top_m - shape_.bottom_m) / 2;
  const glm::dvec3 radii(shape_.radius_m, shape_.radius_m, half_m);
  const glm::dvec3 centre(0, 0, shape_.bottom_m + half_m);
  return in_unit_ball((line.origin_m - centre) / radii, line.direction / radii, kEllipsoid);
}

RayRange Crown::in_trunk(const Line& line) const {
  const glm::dvec3 flat(1 / shape_.trunk_radius_m, 1 / shape_.trunk_radius_m, 0);
  RayRange range = in_unit_ball(line.origin_m * flat, line.direction * flat, kCylinder);
  const double top_m = (shape_.bottom_m + shape_.top_m) / 2;
  range.clip({{0, 0, 1}, top_m}, line.origin_m, line.direction, kTop);
  range.clip({{0, 0, -1}, -shape_.foot_m}, line.origin_m, line.direction, kBottom);
  return range;
}

glm::dvec3 Crown::normal(const glm::dvec3& plumb_m, int surface) const {
  if (surface == kTop) return {0, 0, 1};
  if (surface == kBottom) return {0, 0, -1};
  if (surface == kCylinder) return {plumb_m.x, plumb_m.y, 0};
  const double half_m = (shape_.top_m - shape_.bottom_m) / 2;
  const double squash = shape_.radius_m * shape_.radius_m / (half_m * half_m);
  return {plumb_m.x, plumb_m.y, (plumb_m.z - shape_.bottom_m - half_m) * squash};
}

std::optional<SurfaceHit> Crown::first_hit(const Ray& ray) const {
  const Line line(shape_.level, ray);
  double nearest_m = ray.length_m;
  int surface = -1;
  const auto meet = [&](const RayRange& range) {
    if (range.is_empty()) return;
    const bool enters = range.from >= 0;
    const double t_m = enters ? range.from : range.to;
    if (t_m < 0 || t_m > nearest_m) return;
    nearest_m = t_m;
    surface = enters ? range.enters_by : range.leaves_by;
  };
  meet(in_leaves(line));
  if (shape_.trunk_radius_m > 0) meet(in_trunk(line));
  if (surface < 0) return std::nullopt;
  const glm::dvec3 at = line.origin_m + nearest_m * line.direction;
  return SurfaceHit{nearest_m, ray.origin_m + nearest_m * glm::normalize(ray.direction),
                    glm::normalize(shape_.level.view_normal(normal(at, surface))),
                    surface == kEllipsoid ? kLeaves : kTrunk};
}

}  // namespace terrview

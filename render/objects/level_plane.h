// The plumb line's frame at a place of the view frame.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "terrain/vertical_frame.h"

namespace terrview {

// The plane that touches a level surface above `middle_m`: level ground slopes in the view frame,
// the more the further it is. Off its middle by r the plane is r^2 / (2 R) too high at most, R the
// Earth's radius: 0.8 mm at 100 m.
//
// The plumb frame shares x and y with the view frame, and its z is the height over this plane.
struct LevelPlane {
  glm::dvec2 middle_m{0, 0};
  double z_m = 0;
  glm::dvec2 slope{0, 0};

  [[nodiscard]] double z_at(glm::dvec2 ground_m) const {
    const glm::dvec2 off_m = ground_m - middle_m;
    return z_m + slope.x * off_m.x + slope.y * off_m.y;
  }

  // Points and directions to the plumb frame, and a normal from there (not of unit length).
  [[nodiscard]] glm::dvec3 point(const glm::dvec3& view_m) const {
    return {view_m.x, view_m.y, view_m.z - z_at({view_m.x, view_m.y})};
  }
  [[nodiscard]] glm::dvec3 direction(const glm::dvec3& view) const {
    return {view.x, view.y, view.z - slope.x * view.x - slope.y * view.y};
  }
  // A direction of the plumb frame in the view frame.
  [[nodiscard]] glm::dvec3 view_direction(const glm::dvec3& direction) const {
    return {direction.x, direction.y, direction.z + slope.x * direction.x + slope.y * direction.y};
  }
  [[nodiscard]] glm::dvec3 view_normal(const glm::dvec3& normal) const {
    return {normal.x - slope.x * normal.z, normal.y - slope.y * normal.z, normal.z};
  }
  // A normal to the plumb frame (not of unit length).
  [[nodiscard]] glm::dvec3 plumb_normal(const glm::dvec3& normal) const {
    return {normal.x + slope.x * normal.z, normal.y + slope.y * normal.z, normal.z};
  }
};

// That of the surface of height `scene_height_m` (z_scale included) above a ground point.
[[nodiscard]] LevelPlane level_plane(const VerticalFrame& frame, glm::dvec2 ground_m,
                                     double scene_height_m);

// That of the surface through a point.
[[nodiscard]] LevelPlane level_plane_at(const VerticalFrame& frame, const glm::dvec3& point_m);

}  // namespace terrview

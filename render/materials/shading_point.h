// The point of a surface whose colour is asked for.
#pragma once

#include <glm/vec3.hpp>

namespace terrview {

// Directions are in the plumb frame of the point (render/objects/level_plane.h), where angles are
// true; on a flat Earth it is the view frame.
struct ShadingPoint {
  glm::dvec3 position_m{0, 0, 0};   // view frame
  glm::dvec3 normal{0, 0, 1};       // unit length, on the side that is seen
  glm::dvec3 towards_eye{0, 0, 1};  // unit length: where the ray that meets it comes from
  double width_m = 0;               // of a pixel, across that ray
  bool inside = false;              // the ray comes from within the solid
};

}  // namespace terrview

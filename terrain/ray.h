// A ray of the view frame and what it meets.
#pragma once

#include <limits>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace terrview {

struct Ray {
  glm::dvec3 origin_m{0, 0, 0};
  glm::dvec3 direction{0, 1, 0};  // of any length but 0
  double length_m = std::numeric_limits<double>::infinity();
};

// Where a ray first meets the ground.
struct Hit {
  double distance_m;      // along the ray
  glm::dvec3 position_m;  // on the ray, and on the surface to 1e-9 of the scene's scale
  int grid;               // index of the grid in the Terrain
  glm::ivec2 cell;        // (column, row) of the cell's first post
  glm::dvec2 uv;          // grid coordinates, within the cell
};

}  // namespace terrview

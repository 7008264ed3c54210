// The proportions of a block of ground, and how far it reaches in a picture.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "terrain/terrain.h"

namespace terrview {

// What relief over a block `side_m` long is multiplied by: the largest of 1, 1.5, 2, 2.5, 3, 4, 5,
// 6, 8, 10, 12, 15 and 20 under which it stays within a twentieth of the side; 1 where it does not.
[[nodiscard]] double block_exaggeration(double relief_m, double side_m);

// How deep a block's plinth lies below its lowest ground.
[[nodiscard]] double plinth_depth_m(double side_m);

struct ImageBounds {
  glm::dvec2 low_m;  // along a camera's right and up
  glm::dvec2 high_m;
};

// Of all cells with ground, between the ground and the plinth, on a flat Earth with affine maps.
// Some cell must have ground.
[[nodiscard]] ImageBounds block_bounds(const Terrain& terrain, double plinth_z_m,
                                       const glm::dvec3& right, const glm::dvec3& up);

}  // namespace terrview

// Scenes of objects, made by seed, and rays into them.
#pragma once

#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/objects/object_set.h"
#include "terrain/ray.h"

namespace terrview {

// Boxes of 6 to 20 m and 3 to 30 m height at random in a square of 1000 m^2 for each; their ground
// rises and falls by `relief_m`.
[[nodiscard]] Objects city_scene(int boxes, double relief_m);
[[nodiscard]] double city_extent_m(int boxes);

struct ObjectView {
  std::string name;
  glm::dvec3 eye_m;
  glm::dvec3 to_m;
  double width_rad;  // of the field of view
  glm::ivec2 size_px;
};

// Square pixels, in blocks of 4 x 4.
[[nodiscard]] std::vector<Ray> view_rays(const ObjectView& view);

// From each hit on the objects toward the sun, lifted off by `lift_m`.
[[nodiscard]] std::vector<Ray> shadow_rays(const ObjectSet& set, const std::vector<Ray>& rays,
                                           const glm::dvec3& to_sun, double lift_m);

}  // namespace terrview

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
// rises and falls by `relief_m`. The square is cut into towns of a kilometre that are set apart, so
// that a town begins every `apart` kilometres.
struct City {
  int boxes = 100000;
  double relief_m = 0;
  double apart = 1;

  // A coordinate in the middle of the square, or of a town.
  [[nodiscard]] double middle_m() const;
};

[[nodiscard]] Objects city_scene(const City& city);

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

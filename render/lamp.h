// Lamps: points that light what is around them.
#pragma once

#include <optional>

#include <glm/vec3.hpp>

namespace terrview {

// A cone of light, I0 cos(a) at the angle a to its axis (Warn, SIGGRAPH 1983).
struct Spot {
  glm::dvec3 direction{0, 0, -1};  // of the axis, of any length but 0
  double half_angle_rad = 0.5;     // beyond it there is no light
};

struct Lamp {
  glm::dvec3 position_m{0, 0, 0};  // view frame
  glm::vec3 color{1};              // linear
  double intensity = 1;
  // Where the light is `intensity`: elsewhere it falls with the square of the distance. 0: it is
  // the same everywhere.
  double reference_m = 1;
  std::optional<Spot> spot = {};  // none: it lights all around
};

}  // namespace terrview

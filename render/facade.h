// How much of a building's walls can be seen.
#pragma once

#include <optional>
#include <span>

#include <glm/vec3.hpp>

#include "render/objects/prism.h"
#include "render/scene.h"

namespace terrview {

struct FacadeSight {
  double facing_m2 = 0;  // of the walls over the ground whose outer sides are turned to the eye
  double seen_m2 = 0;    // of these, what nothing hides from the eye
  // Where that is nearest to the eye and farthest from it, to a rectangle (see below).
  std::optional<glm::dvec3> nearest_m = {};
  std::optional<glm::dvec3> farthest_m = {};

  // Adds walls, or a part of one.
  FacadeSight& operator+=(const FacadeSight& more);
};

struct FacadeOptions {
  int samples = 4096;  // about so many for the walls that face the eye
  int threads = 0;     // 0 = all the processor has; never changes the result
};

// Of a building that consists of `parts`, which stand in the scene, from the origin of the view
// frame. Roofs are no walls; neither are edges with the building on both sides. A wall that
// coincides with one of an object that comes before it in the scene is hidden by it. The walls are
// cut into rectangles of about equal area, each seen if a point in it is, which lies elsewhere in
// each, so that errors along an outline cancel: behind four blocks at random the share seen is off
// by 0.0004 (standard deviation of 300 scenes; 0.0013 at the most) for 4096 samples.
[[nodiscard]] FacadeSight facade_sight(const Scene& scene, std::span<const Prism* const> parts,
                                       const FacadeOptions& options = {});

}  // namespace terrview

// The sky and the air.
#pragma once

#include "render/scene.h"

namespace terrview {

// The share q of the light of something `distance_m` away that comes through the air.
[[nodiscard]] float transmission(const Air& air, double distance_m);

// The colour of the air towards `direction`, of unit length.
[[nodiscard]] glm::vec3 air_color(const Scene& scene, const glm::dvec3& direction);

// What is seen where nothing is hit: the sky, or below the horizon the air. A painted sky shows
// rays that do not come from the eye (or from its image in water) no clouds.
[[nodiscard]] glm::vec3 background_color(const Scene& scene, const glm::dvec3& direction,
                                         bool from_eye = true);

}  // namespace terrview

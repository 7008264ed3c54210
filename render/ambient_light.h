// The light of the sky on ground and objects.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/scene.h"

namespace terrview {

// On ground at (u, v) of a layer of the terrain.
[[nodiscard]] glm::vec3 sky_light(const Scene& scene, int grid, glm::dvec2 uv);

// An object sees as much of the sky as it faces, and half as bright ground otherwise. `normal` is
// as Terrain's are.
[[nodiscard]] glm::vec3 light_on_object(const Scene& scene, const glm::dvec3& position_m,
                                        const glm::vec3& normal);

}  // namespace terrview

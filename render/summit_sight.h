// Whether a summit is really seen.
#pragma once

#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/camera.h"
#include "render/scene.h"

namespace terrview {

// Where a summit listed at a place may stand in the terrain, and the other way about: two posts of
// the grid there, and 30 m at least. A listed place is off its top by so much, and on its own
// convex ground it would hide itself.
[[nodiscard]] double summit_reach_m(const Terrain& terrain, const Terrain::Ground& ground,
                                    glm::dvec2 ground_m);

// The highest point, as the camera sees it, of the ground in the vertical plane through the eye (or
// along parallel rays) and the place `ground_m` of the view frame, no further than `reach_m` behind
// it; nullopt if that lies more than `reach_m` before it, or is no nearer than `reach_m` to the
// eye, or an object hides it. So a summit has a point if and only if the ray through that point
// shows ground within its reach; found by bisection to rounding. It may be outside the picture.
//
// This takes the ground to have no holes and to keep within 4 times the reach, up and down, of the
// height at the place as far as the reach goes: elsewhere a summit that is seen may be found
// hidden, or a lower point of it.
[[nodiscard]] std::optional<glm::dvec3> seen_summit(const Scene& scene, const Camera& camera,
                                                    glm::dvec2 ground_m, double reach_m);

// How far the ground at a place stands above the mean of that within 2 km, by scene heights; 0
// where there is none.
[[nodiscard]] double height_above_surroundings_m(const Terrain& terrain, glm::dvec2 ground_m);

}  // namespace terrview

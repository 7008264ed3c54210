// Whether the ground hides the sun from its own points, many at a time, with a SunMap.
//
// What the map knows is a look-up; the others' rays march as those of terrain/occlusion.h do, and
// are free once they come to a cell that the map knows as lit.
#pragma once

#include <cstdint>
#include <span>

#include <glm/vec3.hpp>

#include "terrain/sun_map.h"
#include "terrain/terrain.h"

namespace terrview {

// shaded[i] = whether the ground stops a ray from points_m[i] towards the sun of `map`, as
// Terrain::occluded() has it. The points are those of Terrain::leave(), or on ground_at() and no
// more than the map's `lift_m` above it. The terrain is that of the map, or the same posts seen
// from another eye. Adds to `counts`.
void shaded(const Terrain& terrain, const SunMap& map, std::span<const glm::dvec3> points_m,
            std::span<std::uint8_t> shaded, TraceCounts& counts);

}  // namespace terrview

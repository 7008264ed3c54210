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

// shaded[i] = whether the ground stops a ray from points_m[i], on the ground or above it, towards
// the sun of `map` (direction_at()), as Terrain::occluded() has it. `terrain` is that of the map.
// Adds to `counts`.
void shaded(const Terrain& terrain, const SunMap& map, std::span<const glm::dvec3> points_m,
            std::span<std::uint8_t> shaded, TraceCounts& counts);

}  // namespace terrview

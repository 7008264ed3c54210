// Whether the ground stops rays, many at a time, wherever they begin: shadows.
//
// The rays march in the lanes of a vector, in single precision and in posts from the cell in which
// each begins: a few cells, then blocks of HeightCeilings that grow as the ray rises. Every
// comparison keeps the bound of its rounding: a ray that comes nearer to the ground than that, or
// nearer to a post than its place is known, is given to Terrain::occluded(), so the answers are
// the same under every instruction set.
//
// On a curved Earth a ray's height above the ellipsoid is convex along its ground line: its tangent
// bounds it from below, and what it may rise above that bounds it from above.
#pragma once

#include <cstdint>
#include <span>

#include "terrain/ray.h"
#include "terrain/terrain.h"

namespace terrview {

class SunMap;

// stopped[i] = whether the ground stops rays[i], as Terrain::occluded() has it. Adds to `counts`.
// With `sun`, a map of this terrain, the rays all run towards its sun (direction_at()), and end
// where they come to a cell that it shines on.
void occluded(const Terrain& terrain, std::span<const Ray> rays, std::span<std::uint8_t> stopped,
              TraceCounts& counts, const SunMap* sun = nullptr);

}  // namespace terrview

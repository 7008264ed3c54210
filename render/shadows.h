// Rays towards the light.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "terrain/terrain.h"

namespace terrview {

// Per ray, whether the ground stops it: 0 or 1.
[[nodiscard]] std::vector<std::uint8_t> stopped(const Terrain& terrain, std::span<const Ray> rays);

}  // namespace terrview

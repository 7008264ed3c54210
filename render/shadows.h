// How much of the sun the ground sees.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/scene.h"

namespace terrview {

// Half of the sun's apparent width, 0.533 degrees.
inline constexpr double kSunRadius_rad = 0.00465;

// Per ray, whether the ground stops it: 0 or 1.
[[nodiscard]] std::vector<std::uint8_t> stopped(const Terrain& terrain, std::span<const Ray> rays);

// The share of the sun that each point of the ground sees past the rest of the ground: 0 or 1 for a
// sun without width. For a disc, the height of the horizon is found in each of four upright strips
// of it by halving, since all below a hidden point is hidden: the share is within 0.03 of that of
// every point of the disc (tests/render/shadows_test.cpp). Adds the rays to `shadow_rays`.
[[nodiscard]] std::vector<float> sun_shares(const Terrain& terrain, const Light& light,
                                            std::span<const Hit> points, std::int64_t& shadow_rays);

}  // namespace terrview

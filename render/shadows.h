// How much of the sun the ground sees.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/camera.h"
#include "render/objects/object_set.h"
#include "render/scene.h"

namespace terrview {

// Half of the sun's apparent width, 0.533 degrees.
inline constexpr double kSunRadius_rad = 0.00465;

inline constexpr int kOffGround = -1;

// What throws shadows.
struct ShadowCasters {
  const Terrain& terrain;
  const ObjectSet* objects = nullptr;  // none: the ground alone
  const SunMap* sun_map = nullptr;     // none: rays tell what the ground hides
};
[[nodiscard]] ShadowCasters shadow_casters(const Scene& scene);

// `scene` with a map of the cells that its sun shines on, where that is made sooner than so many
// points find their shadows without; else `scene` itself. Pictures are the same.
[[nodiscard]] Scene with_sun_map(const Scene& scene, std::int64_t points, int threads);
// Of a picture; of a large DEM, of the part that it shows.
[[nodiscard]] Scene with_sun_map(const Scene& scene, const Camera& camera, int threads);

struct ShadowCounts {
  std::int64_t rays = 0;  // or look-ups in a map
  ObjectCounts objects;
};

// Per ray, whether the ground stops it: 0 or 1.
[[nodiscard]] std::vector<std::uint8_t> stopped(const Terrain& terrain, std::span<const Ray> rays);

// The share of the sun that each point sees past the ground and the objects: 0 or 1 for a sun
// without width. For a disc, the height of the horizon is found in each of four upright strips of
// it by halving, since all below a point hidden by the ground is hidden: the share is within 0.03
// of that of every point of the disc (tests/render/shadows_test.cpp). Objects may hide any part of
// the strip above: eight rays tell how much. Adds to `counts`.
//
// Points that are not on the ground, as those of objects, lifted off them, have the grid
// kOffGround; of these only the position counts.
[[nodiscard]] std::vector<float> sun_shares(const ShadowCasters& casters, const Light& light,
                                            std::span<const Hit> points, ShadowCounts& counts);

}  // namespace terrview

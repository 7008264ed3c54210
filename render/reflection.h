// What water mirrors.
#pragma once

#include <span>

#include "render/meet.h"
#include "render/scene.h"
#include "render/shade.h"

namespace terrview {

// Mixes what the water of `hits` mirrors into its clear colours, by Fresnel's law. The mirrored
// rays are traced one by one. Needs Water::reflected. Adds to `counts`.
void add_reflections(const Scene& scene, const RayWidths& widths, std::span<const Ray> rays,
                     const RayHits& hits, std::span<ShadedRay> shaded, ShadowCounts& counts);

}  // namespace terrview

// The colours of objects made of materials.
#pragma once

#include <cstddef>
#include <span>

#include "render/meet.h"
#include "render/scene.h"
#include "render/shade.h"

namespace terrview {

// A ray is mirrored and refracted so often and no more (Guitteny, Le Goff & Lahuec); a surface
// that it meets then shows its own colour alone.
inline constexpr int kMostBounces = 5;

// Fills in the clear colours of the hits `indices`, all of objects with a material there. Mirrored
// and refracted rays are traced together, those of each bounce in one batch; the air dims what they
// show, too. Adds to `counts`.
void shade_materials(const Scene& scene, const RayWidths& widths, std::span<const Ray> rays,
                     const RayHits& hits, std::span<const std::size_t> indices,
                     std::span<ShadedRay> shaded, ShadowCounts& counts);

}  // namespace terrview

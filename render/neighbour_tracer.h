// The rays through the pixels' centres, each begun where its neighbours' hits allow: for study.
//
// A ray is taken to be clear of the ground as far as the nearer of its forerunners' hits, and to
// meet nothing where they meet nothing (Coquillart 1984, chapter 2, 4.1). That is exact within one
// vertical plane; between two, a peak thinner than a pixel can be missed. A ray that its start
// finds below the ground ends there.
#pragma once

#include <optional>

#include "render/camera.h"
#include "render/image.h"
#include "terrain/terrain.h"

namespace terrview {

// Not for an orthographic camera. The same for any number of threads. Adds to `counts`: a test is a
// span of ground compared with a ray, from its start on.
[[nodiscard]] Raster<std::optional<Hit>> trace_by_neighbours(const Terrain& terrain,
                                                             const Camera& camera, int threads,
                                                             TraceCounts& counts);

}  // namespace terrview

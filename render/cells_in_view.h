// Which cells of a DEM a picture shows.
#pragma once

#include "render/camera.h"
#include "terrain/sun_map.h"
#include "terrain/terrain.h"

namespace terrview {

// The cells of the first DEM that hold most of the ground in view: those that rays some pixels
// apart meet, and some around. One cell where none meets it.
[[nodiscard]] CellRect cells_in_view(const Terrain& terrain, const Camera& camera, int threads);

}  // namespace terrview

// What the vector tracers can do: VerticalFrame as series, and 32-bit indices of posts.
#pragma once

#include "terrain/terrain.h"

namespace terrview {

// Whether the series hold all over `terrain`: under 640 km from the eye, or on a flat Earth.
[[nodiscard]] bool within_series_limit(const Terrain& terrain);

// Whether `terrain` is one layer with the hyperboloid surface, fewer than 2^30 posts, and
// within_series_limit().
[[nodiscard]] bool within_vector_limits(const Terrain& terrain);

}  // namespace terrview

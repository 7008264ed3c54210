// What the vector tracers can do: VerticalFrame as series, and 32-bit indices of posts.
#pragma once

#include "terrain/terrain.h"

namespace terrview {

// Whether `terrain` is one layer with the hyperboloid surface, fewer than 2^30 posts, and a reach
// under 640 km.
[[nodiscard]] bool within_vector_limits(const Terrain& terrain);

}  // namespace terrview

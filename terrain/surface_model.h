#pragma once

namespace terrview {

// The surface between posts, as a ray meets it: see terrain/terrain.h.
enum class SurfaceModel { hyperboloid, triangles, bilinear };

}  // namespace terrview

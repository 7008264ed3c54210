// The front of a camera's view.
#pragma once

#include <memory>

#include "render/camera.h"
#include "terrain/eye_front.h"

namespace terrview {

// Null where the camera's rays do not come from the eye, or EyeFront does not serve the terrain,
// which must outlive it.
[[nodiscard]] std::unique_ptr<const EyeFront> view_front(const Terrain& terrain,
                                                         const Camera& camera);

}  // namespace terrview

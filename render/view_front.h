// The front of a camera's view.
#pragma once

#include <memory>
#include <vector>

#include "render/camera.h"
#include "terrain/eye_front.h"

namespace terrview {

// Null where the camera's rays do not come from the eye, or EyeFront does not serve the terrain,
// which must outlive it. With several `threads` (0 = all), where rows of pixels share wedges, these
// are made beforehand by all of them: threads that trace would wait for each other.
[[nodiscard]] std::unique_ptr<const EyeFront> view_front(const Terrain& terrain,
                                                         const Camera& camera, int threads = 1);

// The groups of the front's wedges that the camera sees: of nearly all pixels, and of no others.
[[nodiscard]] std::vector<int> groups_in_view(const EyeFront& front, const Camera& camera);

}  // namespace terrview

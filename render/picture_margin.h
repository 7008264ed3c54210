// What an image must look at beside itself, so that parts of one picture fit each other to the
// byte.
#pragma once

#include "render/camera.h"

namespace terrview {

// The camera's image and `reach_px` about it, as far as the picture that it is a part of goes, in
// pixels of the image. Around a circle there is no end. Begins and ends at multiples of
// `block_px` (the last pixel is the first of a block) from the picture's first pixel, or the
// circle's, so that parts are divided into blocks alike.
[[nodiscard]] PixelRect with_margin(const Camera& camera, int reach_px, int block_px);

}  // namespace terrview

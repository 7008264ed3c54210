// Primary rays in blocks of the image, by the front of their view.
#pragma once

#include "bench/contender.h"
#include "bench/traced_frame.h"
#include "render/camera.h"
#include "terrain/eye_front.h"

namespace terrview {

FrameWork trace_front(const EyeFront& front, const Camera& camera, int threads, TracedFrame& frame);

}  // namespace terrview

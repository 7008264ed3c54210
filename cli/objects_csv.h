// How much of each object a view shows.
#pragma once

#include <string>

#include "cli/view_setup.h"
#include "render/render.h"

namespace terrview {

// The solid angle of a pixel, seen from the eye of a camera whose rays part; 0 for parallel rays.
[[nodiscard]] double pixel_solid_angle_sr(const Camera& camera, glm::ivec2 pixel);

// One line for each feature placed, after a header: docs/cli.md. Needs the frame's samples.
[[nodiscard]] std::string objects_csv(const View& view, const Frame& frame, int threads);

}  // namespace terrview

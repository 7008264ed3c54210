// What a picture says of itself.
#pragma once

#include <string>

#include "cli/camera_json.h"
#include "cli/view_options.h"
#include "sky/sun.h"

namespace terrview {

// JSON of the camera and of whatever else changes the picture, in ASCII; never threads or times.
[[nodiscard]] std::string view_metadata(const ViewOptions& options, const ResolvedView& view,
                                        const SunPosition& sun);

}  // namespace terrview

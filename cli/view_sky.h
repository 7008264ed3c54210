// The sky of a view.
#pragma once

#include <memory>

#include "cli/view_options.h"
#include "ingest/view_frame.h"
#include "render/camera.h"
#include "render/painted_sky.h"
#include "render/scene.h"

namespace terrview {

// --sky, --clouds, --no-sky and what else says how the sky looks.
void add_view_sky_options(CommandLine& app, ViewSkyOptions& sky);

// The sky of `scene`'s light before a camera, with the clouds in their places over the
// ground; null for the plain gradient.
[[nodiscard]] std::shared_ptr<const PaintedSky> paint_view_sky(const ViewSkyOptions& options,
                                                               const ViewFrame& frame,
                                                               const Camera& camera,
                                                               const Scene& scene);

// The same as level mirrors show it.
[[nodiscard]] std::shared_ptr<const PaintedSky> mirror_view_sky(const ViewSkyOptions& options,
                                                                const ViewFrame& frame,
                                                                const Camera& camera,
                                                                const Scene& scene);

}  // namespace terrview

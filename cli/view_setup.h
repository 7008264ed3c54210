// From the options of a view to what is rendered.
#pragma once

#include "cli/camera_json.h"
#include "cli/view_options.h"
#include "ingest/view_frame.h"
#include "render/camera.h"
#include "render/scene.h"

namespace terrview {

// Checks what can be checked before any file is read, and fills in --from-camera. Throws
// InputError.
void prepare(ViewOptions& options);

[[nodiscard]] ViewFrameOptions frame_options(const ViewOptions& options);

// Chooses what the options leave open: the aim, the field of view, the size.
[[nodiscard]] ResolvedView resolve_view(const ViewOptions& options, const ViewFrame& frame,
                                        const std::vector<Dem>& dems);

[[nodiscard]] Camera make_camera(const ResolvedView& view);

// The sun of --sun, or three in the afternoon on the longest day at the eye's latitude.
[[nodiscard]] SunPosition resolve_sun(const ViewOptions& options, const ViewFrame& frame);

[[nodiscard]] Scene make_scene(const ViewOptions& options, const ViewFrame& frame,
                               const SunPosition& sun);

}  // namespace terrview

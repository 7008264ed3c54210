// From the options of a view to what is rendered.
#pragma once

#include "cli/camera_json.h"
#include "cli/shared_inputs.h"
#include "cli/view_labels.h"
#include "cli/view_objects.h"
#include "cli/view_options.h"
#include "ingest/view_frame.h"
#include "render/camera.h"
#include "render/scene.h"

namespace terrview {

[[nodiscard]] ViewFrameOptions frame_options(const ViewOptions& options);

// What the options say of the view before any ground is known: all but the eye and the aim.
[[nodiscard]] ResolvedView known_view(const ViewOptions& options);

// Chooses what the options leave open: the aim, the field of view, the size.
[[nodiscard]] ResolvedView resolve_view(const ViewOptions& options, const ViewFrame& frame,
                                        const std::vector<Dem>& dems);

[[nodiscard]] Camera make_camera(const ResolvedView& view);

// A view with everything made that rendering needs.
struct View {
  ViewFrame frame;
  ResolvedView resolved;
  SunPosition sun;
  Camera camera;
  Scene scene;
  ViewObjects objects;
  ViewLabels labels;
};

[[nodiscard]] View make_view(const ViewOptions& options, const std::vector<Dem>& dems);
[[nodiscard]] View make_view(const ViewOptions& options, const std::vector<Dem>& dems,
                             SharedInputs& inputs);

}  // namespace terrview

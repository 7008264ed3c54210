// `terrview sky` in perspective: its options, and the picture.
#pragma once

#include <optional>

#include <nlohmann/json_fwd.hpp>

#include "cli/progress.h"
#include "render/camera.h"
#include "render/image.h"
#include "sky/sky_painter.h"

namespace terrview {

class CommandLine;

struct SkyPicture {
  CameraOptions camera;
  SkyOptions sky;
  CloudLayer layer;
  double sun_azimuth_deg = 200;
  double sun_elevation_deg = 40;
};

// --projection, --heading, --pitch, --roll, --fov, --sun and what else only a sky in perspective
// has. `flat` becomes false with a --projection.
void add_sky_view_options(CommandLine& app, SkyPicture& view, bool& flat);

// The whole sky of a camera; the same bytes for any number of threads.
[[nodiscard]] Image paint_sky(const SkyOptions& sky, const SkyCamera& camera, int threads,
                              ProgressBar& bar);

// Throws InputError for a view that no camera has.
[[nodiscard]] Image paint_sky_view(const SkyPicture& view, int threads, ProgressBar& bar);

// What the options have become, as a picture says of itself.
[[nodiscard]] nlohmann::ordered_json sky_view_json(const SkyPicture& view);

}  // namespace terrview

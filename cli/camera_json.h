// The resolved camera as JSON: what --camera writes, --from-camera reads, and pictures carry.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "cli/view_options.h"

namespace terrview {

// A view with nothing left to choose. Angles are degrees, as they were given or found, so that the
// JSON makes the same picture again to the byte.
struct ResolvedView {
  EyePlace eye;  // absolute height
  double heading_deg = 0;
  double pitch_deg = 0;
  double roll_deg = 0;
  double fov_deg = 60;
  double width_m = 0;
  glm::ivec2 size_px{1280, 720};
  Projection projection = Projection::perspective;
  glm::dvec2 shift{0, 0};
  std::optional<PixelRect> crop;  // none: all of size_px
  bool plan = false;              // then the camera is a stand-in that looks straight down
  EarthModel earth = EarthModel::curved;
  double refraction = 0.13;
  double z_scale = 1;
};

[[nodiscard]] nlohmann::ordered_json camera_json(const ResolvedView& view);

// Fills what `options` leaves open from the camera file it names. Throws InputError.
void apply_camera_file(ViewOptions& options);

}  // namespace terrview

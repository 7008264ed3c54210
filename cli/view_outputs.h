// What a view writes beside its picture.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "ingest/dem.h"
#include "ingest/view_frame.h"
#include "render/camera.h"
#include "render/render.h"

namespace terrview {

struct WorkSeconds {
  double read = 0;
  double build = 0;
  double render = 0;  // wall clock; divided between trace and shade as the threads' times are
  double write = 0;
};

// Throws InputError if the extension of a --layers file is not known; an empty path is none.
void check_layers_name(const std::string& path);

// --layers: Float64 bands for a GeoTIFF name, float channels for an EXR one.
void write_layers_file(const std::string& path, const Frame& frame, const ViewFrame& view_frame,
                       int threads, const std::string& camera_json);

// --stats.
[[nodiscard]] nlohmann::ordered_json stats_json(const Frame& frame, const ViewFrame& view_frame,
                                                const Camera& camera, const std::vector<Dem>& dems,
                                                const WorkSeconds& seconds);

}  // namespace terrview

// Places to look at a project from.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "ingest/dem.h"
#include "ingest/vector_file.h"

namespace terrview {

struct Viewpoint {
  int number = 0;                      // in file order, from 1
  std::string name;                    // UTF-8, one line; empty = none
  glm::dvec2 place{0, 0};              // (longitude, latitude) in degrees of WGS 84, or see below
  std::optional<double> eye_height_m;  // above the ground
  std::map<std::string, std::string> options;  // of its view, as the command line has them
};

struct ViewpointFile {
  VectorFile file;
  std::vector<Viewpoint> viewpoints;
};

// The points of a vector file that OGR opens. Their fields name (or id), eye_height (or height),
// heading, pitch, roll, fov, shift, size, projection, preset, look_at, sun and time are heeded,
// others are not. A file without a coordinate reference system is in that of `dem`; where `dem` has
// none, places are its coordinates. Throws InputError, also for a feature that is no point on the
// Earth or has a bad eye height.
[[nodiscard]] ViewpointFile read_viewpoints(const std::string& path, const Dem& dem);

}  // namespace terrview

// What is to be built, as a study of its impact knows it before any view.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "cli/shared_inputs.h"
#include "cli/view_options.h"
#include "ingest/view_frame.h"

namespace terrview {

// (longitude, latitude) in degrees of WGS 84, or the first DEM's own coordinates where DEMs have no
// coordinate system.
using PlanPlace = glm::dvec2;

struct ProjectBuilding {
  std::int32_t id;   // in the views with the project
  int number;        // of the feature in its file
  std::string name;  // UTF-8; may be empty
  double height_m;
  std::vector<std::vector<PlanPlace>> outlines;  // of its parts, closed
};

struct Project {
  std::int32_t before = 0;  // the ids of the buildings that stand already end here
  bool geographic = true;
  std::vector<ProjectBuilding> buildings;
  PlanPlace middle{0, 0};
  double middle_m = 0;  // over the ground there: half of the highest building
  // The corners and the middle of every roof.
  std::vector<EyePlace> roof_points;
};

// `options` are those of a view with the project, whose last `files` of buildings are the
// project's. Throws InputError.
[[nodiscard]] Project read_project(const ViewOptions& options, std::size_t files,
                                   const std::vector<Dem>& dems, SharedInputs& inputs);

}  // namespace terrview

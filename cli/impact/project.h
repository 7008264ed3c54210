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
using PlanPolygon = std::vector<std::vector<PlanPlace>>;  // closed rings: the outer, then holes

// Of a point of the ground in a frame.
[[nodiscard]] PlanPlace plan_place(const ViewFrame& frame, glm::dvec2 ground_m);

struct ProjectBuilding {
  std::int32_t id;   // in the views with the project
  int number;        // of the feature in its file
  std::string name;  // UTF-8; may be empty
  double height_m;
  std::vector<PlanPolygon> parts;
};

struct Project {
  std::int32_t before = 0;  // the ids of the buildings that stand already end here
  std::int32_t last = 0;    // and those of the project here
  bool geographic = true;
  std::vector<ProjectBuilding> buildings;
  PlanPlace middle{0, 0};
  double middle_m = 0;  // over the ground there: half of the highest building
  // The corners of every roof, those of its courtyards too, and its middle: that of its bounding
  // box, or if the roof is not there, a point well inside.
  std::vector<EyePlace> roof_points;
};

// `options` are those of a view with the project, whose last `files` of buildings are the
// project's. Throws InputError.
[[nodiscard]] Project read_project(const ViewOptions& options, std::size_t files,
                                   const std::vector<Dem>& dems, SharedInputs& inputs);

}  // namespace terrview

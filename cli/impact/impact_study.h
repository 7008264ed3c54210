// What a project changes, viewpoint by viewpoint.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/camera_json.h"
#include "cli/impact/building_sight.h"
#include "cli/impact/impact_files.h"
#include "cli/impact/impact_options.h"
#include "cli/impact/project.h"
#include "ingest/viewpoint_file.h"

namespace terrview {

// The nearest or farthest point of a project that is seen.
struct StudyPoint {
  PlanPlace place{0, 0};
  double height_m = 0;    // in the DEM's heights
  double distance_m = 0;  // straight from the eye
};

// What is seen of a building, or of all of them.
struct SightNumbers {
  std::int64_t pixels = 0;  // of the picture
  double solid_angle_sr = 0;
  FacadeSight facade;
  std::optional<StudyPoint> nearest;  // none: nothing is seen
  std::optional<StudyPoint> farthest;

  [[nodiscard]] bool is_seen() const { return nearest.has_value(); }
  // None: no wall faces the eye.
  [[nodiscard]] std::optional<double> facade_share() const;
};

// A picture for the report, as the bytes of a file.
struct StudyPictures {
  std::string before_jpg;
  std::string after_jpg;
  std::string difference_png;
  std::string wireline_svg;
};

struct ViewpointStudy {
  Viewpoint viewpoint;
  std::string name;                   // never empty
  std::string error;                  // not empty: there is nothing else
  std::vector<std::string> warnings;  // one line each
  std::string before_command;
  std::string after_command;
  std::string scene;       // a scene file of the view after
  std::string scene_name;  // the name of that file
  ResolvedView camera;
  std::optional<double> ground_m;  // under the eye, in the DEM's heights
  SunPosition sun;
  SightNumbers project;
  std::vector<SightNumbers> buildings;  // one for each of the project's
  std::int64_t changed_px = 0;
  std::optional<double> horizon_changed;  // share of the columns with a horizon; none: no column
  StudyPictures pictures;
};

// What the views of a study share.
struct StudyGround {
  const ImpactOptions& options;
  const Project& project;
  const std::vector<Dem>& dems;
  SharedInputs& inputs;
};

// Fills the files of a viewpoint; what keeps it from being seen becomes its error. Throws
// Interrupted.
[[nodiscard]] ViewpointStudy study_viewpoint(const StudyGround& ground, const Viewpoint& viewpoint,
                                             ImpactFiles::OfViewpoint& files);

}  // namespace terrview

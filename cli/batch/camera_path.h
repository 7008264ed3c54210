// A camera that moves: from keyframes or a GPX track to a table with a row a picture.
#pragma once

#include <optional>
#include <string>

#include "cli/batch/job_table.h"

namespace terrview {

struct PathOptions {
  double frames_per_s = 25;
  std::optional<double> duration_s{};     // of the film; the keyframes' own, or 20 s for a track
  std::optional<double> speed_m_per_s{};  // of a track, instead
  std::optional<double> lift_m{};         // of a track's eye over the ground; 2 m
  bool aims = true;  // a track's camera looks ahead; false: the user says where
};

// Keyframes: a table with the column time (seconds, increasing) or frame (from 1), and columns of
// options. eye, look-at, their -xy, heading, pitch, roll, fov, width and sun move smoothly from one
// keyframe that has them to the next (cli/batch/spline.h; angles the shorter way, heights over the
// ground between those of the keyframes); others keep the last keyframe's. Throws InputError.
[[nodiscard]] JobTable frames_of_keyframes(const JobTable& keyframes, const PathOptions& options);

// Throws InputError also for a file that is neither a table nor GPX.
[[nodiscard]] JobTable read_camera_path(const std::string& path, const PathOptions& options);

}  // namespace terrview

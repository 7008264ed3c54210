// The zone of theoretical visibility: from where on a DEM a project can be seen.
//
// An observer stands above every post of the first DEM. A target is seen from there if the ground
// (that of all DEMs, as pictures have it: surface model, curved Earth, refraction) does not stop
// the line between the two, nor an obstacle: render/post_sight.h says it exactly. The project
// itself is no obstacle, so what it hides of itself counts as seen.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "ingest/dem.h"
#include "ingest/view_frame.h"
#include "render/objects/object_set.h"

namespace terrview {

struct ZoneOptions {
  double observer_m = 1.6;  // above the ground
  // As for pictures; beyond_sight, above_ground_m and under_ground are not asked.
  ViewFrameOptions frame = {};
  // What hides targets beside the ground, in the view frame of a target; null = nothing.
  std::function<std::shared_ptr<const ObjectSet>(const ViewFrame& frame)> obstacles = {};
  std::function<void(double share)> progress = {};  // called after each target, 0 to 1
  bool plain = false;  // a ray a post, as PostSightOptions: the same zone, slowly
};

// On the posts of a DEM, row by row.
struct Zone {
  static constexpr float kNoData = -1;

  int columns = 0;
  int rows = 0;
  PostPlacement placement;
  std::string crs_wkt;
  // How many targets are seen; kNoData where the DEM has no height.
  std::vector<float> counts;
  // The largest angle between the directions to any two of the targets seen: how much of the field
  // of view the project takes up, upright or across. 0 where fewer than two are seen. Right to
  // 1e-5 rad: refraction lifts both alike.
  std::vector<float> angles_rad;

  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  }
};

// `targets` are places of points of the project, as those of eyes: roofs' corners and centres. A
// target under the ground is seen from nowhere. The same for any number of threads. Throws
// InputError: as ViewFrame, naming the target by its number from 1; no target; an observer under
// the ground.
[[nodiscard]] Zone visible_zone(const std::vector<Dem>& dems, const std::vector<EyePlace>& targets,
                                const ZoneOptions& options = {});

}  // namespace terrview

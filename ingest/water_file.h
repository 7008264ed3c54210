// Lakes from vector files, laid into DEMs.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ingest/dem.h"
#include "ingest/vector_file.h"
#include "render/lakes.h"

namespace terrview {

// A feature with an area.
struct WaterBody {
  int number = 0;                                    // of the feature in its file, from 1
  std::vector<std::vector<Polygon::Ring>> polygons;  // in the file's coordinates
  std::optional<double> level_m;                     // none: the file does not say
};

struct WaterBodies {
  VectorFile file;
  std::vector<WaterBody> bodies;
  int without_area = 0;  // features that have none: rivers drawn as lines
};

// The level is that of the first field set of level_m, level, water_level, elevation and ele.
// Throws InputError, also for a level that is no number of metres.
[[nodiscard]] WaterBodies read_water(const std::string& path);

// DEMs with lakes in them.
struct FloodedDems {
  std::vector<Dem> dems;
  std::vector<std::shared_ptr<const Lakes>> lakes;  // of each DEM; null = none
  int placed = 0;                                   // bodies that touch a DEM
  int from_shore = 0;                               // of those, without a level of their own
};

// Hydro-flattening: all posts of the cells that a body touches, voids too, are set to its level, so
// that inside its outline the ground is level water; between the outline and the next posts it is a
// flat shore. Where the file does not say the level, it is the lower quartile of the ground along
// the outline, or of that inside where there is none along it, in the first DEM that has any.
// Outlines are straight between their corners in each DEM's grid. Later bodies win.
//
// A file without a coordinate reference system, and any file over a DEM without one, is in that
// DEM's own coordinates. Throws InputError, also if no body touches a DEM.
[[nodiscard]] FloodedDems flood(const std::vector<Dem>& dems, const WaterBodies& water);

}  // namespace terrview

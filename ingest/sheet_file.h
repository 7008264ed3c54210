// The outlines of map sheets from a vector file.
#pragma once

#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "ingest/dem.h"

namespace terrview {

// The rectangle about a feature's corners, in a DEM's coordinates.
struct SheetOutline {
  int number;  // in file order, from 1
  std::string name;
  glm::dvec2 low;
  glm::dvec2 high;
};

// Outlines in another coordinate system are moved into the DEM's corner by corner; those of a file
// without one are in the DEM's. Throws InputError, also for a feature without a name in `field`.
[[nodiscard]] std::vector<SheetOutline> read_sheet_outlines(const std::string& path,
                                                            const std::string& field,
                                                            const Dem& dem);

}  // namespace terrview

// Height grids to GeoTIFF, through GDAL.
#pragma once

#include <map>
#include <string>

#include <glm/vec2.hpp>

#include "terrain/height_grid.h"

namespace terrview {

struct HeightFileOptions {
  std::string crs = {};                              // as --a-srs; empty: none
  glm::dvec2 spacing{30, 30};                        // between posts, in the CRS's units
  glm::dvec2 south_west{0, 0};                       // the place of the south-west post
  std::string format = {};                           // GTiff; empty: by extension
  std::map<std::string, std::string> creation = {};  // those of GDAL's that the next one lists
  std::string description = {};                      // the image's
};

[[nodiscard]] std::string heights_creation_keys();

// Throws InputError for a file that is no GeoTIFF, a creation option that does not fit heights, or
// a CRS that PROJ does not know.
void check_heights_file(const std::string& path, const HeightFileOptions& options);

// Float32, deflated unless told otherwise, row 0 in the north. Throws InputError for the CRS, and
// std::runtime_error with the reason, but not the path, if writing fails.
void write_heights(const std::string& path, const HeightGrid& grid,
                   const HeightFileOptions& options);

}  // namespace terrview

// Height grids to GeoTIFF, through GDAL.
#pragma once

#include <string>

#include <glm/vec2.hpp>

#include "terrain/height_grid.h"

namespace terrview {

struct HeightFileOptions {
  std::string crs = {};         // as --a-srs; empty: none
  glm::dvec2 spacing{30, 30};   // between posts, in the CRS's units
  glm::dvec2 south_west{0, 0};  // the place of the south-west post
};

// Throws InputError for a CRS that PROJ does not know.
void check_crs(const std::string& crs);

// Float32, deflated, row 0 in the north. Throws InputError as check_crs() does, and
// std::runtime_error with the reason, but not the path, if writing fails.
void write_heights(const std::string& path, const HeightGrid& grid,
                   const HeightFileOptions& options);

}  // namespace terrview

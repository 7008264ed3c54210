// Heights out of a raster, block by block, straight into a grid.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "ingest/dem_source.h"

namespace terrview {

// Where a part of a file goes.
struct HeightTarget {
  PostWindow window;          // of the file
  bool flip_columns = false;  // the file's columns run from east to west
  bool flip_rows = false;     // its rows run from south to north
  glm::ivec2 first{0, 0};     // post of the grid that the window's north-west post becomes
};

// Writes the heights of `target.window` to the posts of `grid` that have none yet; `read` is called
// after each block with its number of posts. Returns warnings. Throws InputError if the file cannot
// be read to its end.
std::vector<std::string> read_heights(DemSource& source, const HeightTarget& target,
                                      HeightGrid& grid, GdalScope& scope,
                                      const std::function<void(double posts)>& read);

// The bytes GDAL needs at once beside the grid.
[[nodiscard]] double block_bytes(const DemSource& source);

}  // namespace terrview

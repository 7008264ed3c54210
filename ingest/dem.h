// Digital elevation models from files, through GDAL.
//
// A Dem is one raster, or several that continue one lattice, as terrview sees it: heights on posts,
// and how the posts lie in a coordinate reference system. A post is a pixel's centre under GDAL's
// geotransform, always. Heights are metres: scale, offset, unit and nodata of the file are already
// applied, and nothing is ever resampled.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/mat2x2.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>

#include "terrain/height_ceilings.h"
#include "terrain/height_grid.h"
#include "terrain/mean_heights.h"

namespace terrview {

// (x, y) = origin + step * (u, v): from posts to coordinates of the CRS in its own unit, x to the
// east (longitude), whatever axis order its authority prefers.
struct PostPlacement {
  glm::dvec2 origin{0, 0};
  glm::dmat2 step{1, 0, 0, -1};  // column 0: one post along u; column 1: one post along v

  [[nodiscard]] glm::dvec2 at(glm::dvec2 uv) const { return origin + step * uv; }
  [[nodiscard]] glm::dvec2 posts(glm::dvec2 xy) const { return glm::inverse(step) * (xy - origin); }
};

// Part of a file: first column, first row, width and height, in posts of the file.
using PostWindow = std::array<int, 4>;

// What a file says of itself (or the options in its stead), without its heights.
struct DemHeader {
  std::string name;  // as given by the user
  int columns = 0;   // of the whole file
  int rows = 0;
  PostPlacement placement;     // of the file's posts, in file order
  std::string crs_wkt;         // horizontal; empty = none: flat, x east and y north
  bool geographic = false;     // x is a longitude, y a latitude, in degrees
  std::string vertical_datum;  // name, empty = unknown
  std::string height_unit;     // of the file's numbers, as it calls it
  double metres_per_unit = 1;
  std::vector<std::string> warnings;
};

struct DemOptions {
  std::string crs;                      // --a-srs: anything PROJ understands; empty = the file's
  std::optional<glm::dvec2> spacing;    // --spacing: the file's south-west post is (0, 0), no CRS
  std::optional<double> height_factor;  // the DZ of --spacing: metres, instead of the file's unit
  std::string height_unit;              // --z-unit: m, ft, us-ft, cm, ...; empty = the file's
  std::optional<PostWindow> window;     // of every file
  int band = 1;
  std::optional<double> nodata;  // a number of the file, before scale and offset
  bool fill_voids = true;        // interior voids up to kFilledVoid_posts across
  std::size_t memory_bytes = 0;  // --memory: refuse to need more; 0 = half of the machine's
  std::function<void(double share)> progress;  // called now and then, 0 to 1

  // Instead of `window`: the part to read of each file, nullopt = none of it. Leave a margin of
  // kFilledVoid_posts, so that voids are filled as they would be in the whole file.
  std::function<std::optional<PostWindow>(const DemHeader&)> choose_window;
};

// Rows run from north to south and columns from west to east, whatever the order in the file,
// unless the raster is rotated.
struct Dem {
  std::string name;  // as given by the user: the paths joined by " + "
  std::shared_ptr<const HeightGrid> grid;
  PostPlacement placement;
  std::string crs_wkt;           // empty = none: flat, x east and y north
  std::string vertical_datum;    // name, empty = unknown
  std::string height_unit;       // of the file's numbers, as it calls it; heights are metres
  std::size_t voids_filled = 0;  // posts
  std::size_t voids_open = 0;
  std::vector<std::string> warnings;  // one line each, for the user

  // Those of the grid, where views share them; each view makes its own otherwise.
  std::shared_ptr<const HeightCeilings> ceilings{};
  std::shared_ptr<const MeanHeights> means{};
};

inline constexpr int kFilledVoid_posts = 32;

// No height above or below this, in metres, is one: no solid body known has such relief. It is read
// as no data, with a warning.
inline constexpr double kHighest_m = 100'000;

// Reads every path, in order of preference. Grids that continue one lattice (same CRS and step,
// origins apart by whole posts to 1/1000 of a step) and touch are joined into one Dem, which takes
// the place of the first of them; where they overlap the first that has a height wins. A Dem
// without any height is left out. Throws InputError.
[[nodiscard]] std::vector<Dem> read_dems(const std::vector<std::string>& paths,
                                         const DemOptions& options = {});

// What read_dems() would go by; no height is read. Throws InputError.
[[nodiscard]] DemHeader read_dem_header(const std::string& path, const DemOptions& options = {});

}  // namespace terrview

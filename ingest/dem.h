// Digital elevation models from files, through GDAL.
//
// A Dem is one raster as terrview sees it: heights on posts, and how the posts lie in a coordinate
// reference system. A post is a pixel's centre under GDAL's geotransform, always. Heights are
// metres: scale, offset, unit and nodata of the file are already applied.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>

#include "terrain/height_grid.h"

namespace terrview {

// (x, y) = origin + step * (u, v): from posts to coordinates of the CRS, x to the east (longitude
// in degrees where the CRS is geographic), whatever axis order its authority prefers.
struct PostPlacement {
  glm::dvec2 origin{0, 0};
  glm::dmat2 step{1, 0, 0, -1};  // column 0: one post along u; column 1: one post along v

  [[nodiscard]] glm::dvec2 at(glm::dvec2 uv) const { return origin + step * uv; }
};

struct DemOptions {
  std::string crs;                    // --a-srs: anything PROJ understands; empty = the file's
  std::optional<glm::dvec2> spacing;  // --spacing: the south-west post is (0, 0), no CRS
  double height_factor = 1;           // the DZ of --spacing: metres per unit of height
  std::string height_unit;            // --z-unit: m, ft, us-ft, cm, ...; empty = the file's
  std::optional<std::array<int, 4>> window;  // column, row, width, height, in posts of the file
  int band = 1;
  std::optional<double> nodata;
  bool fill_voids = true;        // interior voids up to kFilledVoid_posts across
  std::size_t memory_bytes = 0;  // refuse to allocate more than this; 0 = half of the machine's
  std::function<void(double share)> progress;  // called now and then, 0 to 1
};

struct Dem {
  std::string name;  // as given by the user: the paths joined by " + "
  std::shared_ptr<const HeightGrid> grid;
  PostPlacement placement;
  std::string crs_wkt;           // empty = none: flat, x east and y north
  std::string vertical_datum;    // name, empty = unknown
  std::size_t voids_filled = 0;  // posts
  std::size_t voids_open = 0;
};

inline constexpr int kFilledVoid_posts = 32;

// Reads every path, in order of preference. Grids that continue one lattice are joined into one
// Dem, which takes the place of the first of them. Throws InputError.
[[nodiscard]] std::vector<Dem> read_dems(const std::vector<std::string>& paths,
                                         const DemOptions& options = {});

}  // namespace terrview

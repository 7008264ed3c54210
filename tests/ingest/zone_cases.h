// DEMs and targets of the tests of zones.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "ingest/zone.h"

namespace terrview::cases {

inline std::shared_ptr<const HeightGrid> grid_of(
    glm::ivec2 posts, const std::function<double(int column, int row)>& height_m) {
  auto grid = std::make_shared<HeightGrid>();
  grid->columns = posts.x;
  grid->rows = posts.y;
  for (int row = 0; row < posts.y; ++row)
    for (int column = 0; column < posts.x; ++column)
      grid->heights_m.push_back(static_cast<float>(height_m(column, row)));
  return grid;
}

// Without a CRS; the south-west post is at (0, 0).
inline Dem laid_flat(int columns, int rows, double spacing_m,
                     const std::function<double(int column, int row)>& height_m) {
  Dem dem;
  dem.name = "flat";
  dem.grid = grid_of({columns, rows}, height_m);
  dem.placement = {{0, spacing_m * (rows - 1)}, glm::dmat2(spacing_m, 0, 0, -spacing_m)};
  return dem;
}

inline Dem laid(const std::string& crs, glm::dvec2 north_west, double spacing,
                std::shared_ptr<const HeightGrid> grid) {
  Dem dem;
  dem.name = crs;
  dem.grid = std::move(grid);
  dem.placement = {north_west, glm::dmat2(spacing, 0, 0, -spacing)};
  dem.crs_wkt = crs;
  return dem;
}

// Level ground at 0.
inline Dem sea(const std::string& crs, glm::dvec2 north_west, double spacing, glm::ivec2 posts) {
  return laid(crs, north_west, spacing, grid_of(posts, [](int, int) { return 0.0; }));
}

// In the DEM's own coordinates, at an absolute height.
inline EyePlace target_at(glm::dvec2 xy, double height_m) {
  return {.geographic = {}, .projected = xy, .height_m = height_m, .above_ground = false};
}

}  // namespace terrview::cases

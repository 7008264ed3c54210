#include "bench/bench_dem.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "terrain/grid_walk.h"

namespace terrview {

glm::dvec2 BenchDem::middle_uv() const { return {grid->columns / 2, grid->rows / 2}; }

double BenchDem::extent_m() const {
  return std::max(glm::length(step_m[0]) * (grid->columns - 1),
                  glm::length(step_m[1]) * (grid->rows - 1));
}

double BenchDem::height_m(glm::dvec2 uv) const {
  return height_at(*grid, SurfaceModel::bilinear, cell_of(*grid, uv), uv);
}

BenchDem make_bench_dem(std::string name, HeightGrid grid, const glm::dmat2& step_m) {
  cover_voids(grid);
  BenchDem dem{std::move(name), std::make_shared<const HeightGrid>(std::move(grid)), step_m};
  // Of the 24 bits of a float, 3 are left for fractions of a post.
  const double quantum_m = std::exp2(std::ceil(std::log2(dem.extent_m())) - 20);
  for (int along = 0; along < 2; ++along)
    dem.step_m[along] = glm::round(dem.step_m[along] / quantum_m) * quantum_m;
  return dem;
}

}  // namespace terrview

#include "tests/support/scenes.h"

#include <cmath>
#include <memory>
#include <utility>

#include <glm/geometric.hpp>

namespace terrview {

HeightGrid make_grid(int columns, int rows,
                     const std::function<double(int column, int row)>& height_m) {
  HeightGrid grid{columns, rows, {}};
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      grid.heights_m.push_back(static_cast<float>(height_m(column, row)));
  return grid;
}

TerrainLayer make_layer(HeightGrid grid, const Place& place) {
  const glm::dmat2 jacobian(1 / place.spacing_m.x, 0, 0, -1 / place.spacing_m.y);
  const glm::ivec2 size(grid.columns, grid.rows);
  return {std::make_shared<const HeightGrid>(std::move(grid)),
          std::make_shared<const AffineGroundMap>(place.eye_uv, jacobian, size)};
}

Terrain make_terrain(HeightGrid grid, const Place& place, SurfaceModel model) {
  VerticalFrame frame;
  frame.eye_height_m = place.eye_height_m;
  frame.z_scale = place.z_scale;
  return {{make_layer(std::move(grid), place)}, frame, model};
}

Ray ray_towards(const glm::dvec3& from_m, const glm::dvec3& to_m) {
  return {from_m, glm::normalize(to_m - from_m)};
}

std::vector<Ray> rays_all_round(int count) {
  std::vector<Ray> rays;
  for (int i = 0; i < count; ++i) {
    const double azimuth = 2 * 3.14159265358979323846 * i / count;
    rays.push_back({.direction = {std::sin(azimuth), std::cos(azimuth), 0}});
  }
  return rays;
}

glm::dvec2 ground_of(const Place& place, glm::dvec2 uv) {
  return {(uv.x - place.eye_uv.x) * place.spacing_m.x, (place.eye_uv.y - uv.y) * place.spacing_m.y};
}

}  // namespace terrview

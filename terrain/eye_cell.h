// Where the eye stands in the grid of a terrain of one layer.
#pragma once

#include "terrain/terrain.h"

namespace terrview {

struct EyeCell {
  explicit EyeCell(const Terrain& terrain) {
    const glm::dvec2 uv = terrain.layers()[0].map->to_grid({0, 0});
    u = uv.x;
    v = uv.y;
    if (const auto ground = terrain.ground_at({0, 0})) {
      column = ground->cell.x;
      row = ground->cell.y;
      z_m = terrain.frame().at({0, 0}).z_m(ground->scene_height_m);
    }
  }

  // Not on it, nor below; also where there is no ground.
  [[nodiscard]] bool is_above_ground() const { return column < 0 || z_m < 0; }

  double u;
  double v;
  // Where the eye is not over ground, no cell is its cell.
  double column = -2;
  double row = -2;
  double z_m = 0;  // of the ground below
};

}  // namespace terrview

// Small terrains whose answers are known in closed form.
#pragma once

#include <functional>
#include <limits>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "terrain/terrain.h"

namespace terrview {

inline constexpr float kVoid = std::numeric_limits<float>::quiet_NaN();

[[nodiscard]] HeightGrid make_grid(int columns, int rows,
                                   const std::function<double(int column, int row)>& height_m);

// Where a grid lies about the eye: rows run south, columns east.
struct Place {
  glm::dvec2 eye_uv{0, 0};
  glm::dvec2 spacing_m{1, 1};
  double eye_height_m = 0;
  double z_scale = 1;
};

[[nodiscard]] TerrainLayer make_layer(HeightGrid grid, const Place& place);

// On a flat Earth.
[[nodiscard]] Terrain make_terrain(HeightGrid grid, const Place& place, SurfaceModel model);

[[nodiscard]] Ray ray_towards(const glm::dvec3& from_m, const glm::dvec3& to_m);

// Level rays from the eye, evenly spread in azimuth from north.
[[nodiscard]] std::vector<Ray> rays_all_round(int count);

// The ground point of a post or any other (u, v) of a grid so placed.
[[nodiscard]] glm::dvec2 ground_of(const Place& place, glm::dvec2 uv);

}  // namespace terrview

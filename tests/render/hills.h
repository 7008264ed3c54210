// A small landscape and its pictures.
#pragma once

#include <cmath>
#include <memory>
#include <numbers>

#include "bench/psnr.h"
#include "render/render.h"
#include "tests/support/scenes.h"

namespace terrview {

inline constexpr double kRadians = std::numbers::pi / 180;

[[nodiscard]] inline glm::dvec3 sun_at(double azimuth_deg, double elevation_deg) {
  const double run = std::cos(elevation_deg * kRadians);
  return {run * std::sin(azimuth_deg * kRadians), run * std::cos(azimuth_deg * kRadians),
          std::sin(elevation_deg * kRadians)};
}

[[nodiscard]] inline HeightGrid hills_grid() {
  return make_grid(120, 120, [](int column, int row) {
    return 160 * std::sin(column * 0.35) * std::cos(row * 0.22) +
           40 * std::sin(column * 0.9 + row * 0.7) + 300;
  });
}

// `grid`, 100 m a post, under an eye in the middle of its south side.
[[nodiscard]] inline Scene scene_over(HeightGrid grid, double eye_height_m) {
  const Place place{.eye_uv = {(grid.columns - 1) / 2.0, grid.rows - 2.0},
                    .spacing_m = {100, 100},
                    .eye_height_m = eye_height_m};
  Scene scene;
  scene.terrain =
      std::make_shared<Terrain>(make_terrain(std::move(grid), place, SurfaceModel::hyperboloid));
  scene.tints = {.stops = {{0, {0.1F, 0.3F, 0.1F}}, {500, {0.8F, 0.7F, 0.6F}}}};
  scene.light.towards_sun = sun_at(250, 25);
  return scene;
}

[[nodiscard]] inline Scene hills_scene() { return scene_over(hills_grid(), 700); }

// Level, and therefore traced by columns; and the same with a roll, ray by ray.
[[nodiscard]] inline Camera level_camera(glm::ivec2 size_px) {
  return Camera({.size_px = size_px});
}
[[nodiscard]] inline Camera tilted_camera(glm::ivec2 size_px) {
  return Camera({.pitch_rad = -8 * kRadians, .roll_rad = 3 * kRadians, .size_px = size_px});
}

}  // namespace terrview

#include "render/sky_light.h"

#include <glm/matrix.hpp>

#include "render/parallel.h"

namespace terrview {
namespace {

// The map at the middle of a grid, wherever the eye is.
glm::dmat2 jacobian_at_middle(const TerrainLayer& layer) {
  const glm::dvec2 middle = 0.5 * glm::dvec2(layer.grid->columns - 1, layer.grid->rows - 1);
  glm::dvec2 ground_m(0);
  for (int i = 0; i < 4; ++i)
    ground_m +=
        glm::inverse(layer.map->jacobian(ground_m)) * (middle - layer.map->to_grid(ground_m));
  return layer.map->jacobian(ground_m);
}

}  // namespace

std::vector<SkyView> sky_views(const Terrain& terrain, const SkyLightOptions& options) {
  std::vector<SkyView> views;
  const double layers = static_cast<double>(terrain.layers().size());
  for (const TerrainLayer& layer : terrain.layers()) {
    SkyViewSweep sweep(*layer.grid, jacobian_at_middle(layer), terrain.frame().z_scale,
                       options.azimuths);
    for (int step = 0; step < sweep.steps(); ++step) {
      parallel_for(sweep.parts(step), options.threads, [&](int part) { sweep.sweep(step, part); });
      if (options.progress)
        options.progress(
            (static_cast<double>(views.size()) + static_cast<double>(step + 1) / sweep.steps()) /
            layers);
    }
    views.push_back(sweep.result());
  }
  return views;
}

}  // namespace terrview

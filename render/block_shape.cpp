#include "render/block_shape.h"

#include <array>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace terrview {
namespace {

constexpr double kReliefShare = 1.0 / 20;
constexpr double kPlinthShare = 1.0 / 40;

// Whether a post is a corner of a cell that has ground.
bool carries_ground(const HeightGrid& grid, int column, int row) {
  for (int y = row - 1; y <= row; ++y) {
    for (int x = column - 1; x <= column; ++x)
      if (x >= 0 && y >= 0 && x < grid.columns - 1 && y < grid.rows - 1 && grid.has_ground(x, y))
        return true;
  }
  return false;
}

}  // namespace

double block_exaggeration(double relief_m, double side_m) {
  constexpr std::array<double, 12> kSteps{1.5, 2, 2.5, 3, 4, 5, 6, 8, 10, 12, 15, 20};
  double best = 1;
  for (const double step : kSteps)
    if (relief_m > 0 && step * relief_m <= kReliefShare * side_m) best = step;
  return best;
}

double plinth_depth_m(double side_m) { return kPlinthShare * side_m; }

ImageBounds block_bounds(const Terrain& terrain, double plinth_z_m, const glm::dvec3& right,
                         const glm::dvec3& up) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  ImageBounds bounds{glm::dvec2(kFar), glm::dvec2(-kFar)};
  const VerticalFrame& frame = terrain.frame();
  for (const TerrainLayer& layer : terrain.layers()) {
    const HeightGrid& grid = *layer.grid;
    const glm::dvec2 below_eye = layer.map->to_grid(glm::dvec2(0));
    const glm::dmat2 to_ground = glm::inverse(*layer.map->linear());
    for (int row = 0; row < grid.rows; ++row) {
      for (int column = 0; column < grid.columns; ++column) {
        if (!carries_ground(grid, column, row)) continue;
        const glm::dvec2 ground_m = to_ground * (glm::dvec2(column, row) - below_eye);
        const double top_z_m = frame.z_scale * grid.at(column, row) - frame.eye_height_m;
        for (const double z_m : {top_z_m, plinth_z_m}) {
          const glm::dvec3 point(ground_m, z_m);
          const glm::dvec2 image(glm::dot(point, right), glm::dot(point, up));
          bounds.low_m = glm::min(bounds.low_m, image);
          bounds.high_m = glm::max(bounds.high_m, image);
        }
      }
    }
  }
  return bounds;
}

}  // namespace terrview

#include "terrain/vector_limits.h"

#include <algorithm>

#include "terrain/vertical_math.h"

namespace terrview {

bool within_vector_limits(const Terrain& terrain) {
  if (terrain.layers().size() != 1 || terrain.model() != SurfaceModel::hyperboloid) return false;
  const HeightGrid& grid = *terrain.layers()[0].grid;
  const VerticalFrame& frame = terrain.frame();
  const double gamma =
      terrain.reach_m() * std::max(frame.north_curvature_per_m, frame.east_curvature_per_m);
  constexpr double kMostPosts = 1 << 30;
  return gamma * gamma < kSeriesLimit && static_cast<double>(grid.columns) * grid.rows < kMostPosts;
}

}  // namespace terrview

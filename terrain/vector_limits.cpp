#include "terrain/vector_limits.h"

#include <algorithm>

#include "terrain/vertical_math.h"

namespace terrview {

bool within_series_limit(const Terrain& terrain) {
  const VerticalFrame& frame = terrain.frame();
  const double gamma =
      terrain.reach_m() * std::max(frame.north_curvature_per_m, frame.east_curvature_per_m);
  return gamma * gamma < kSeriesLimit;
}

bool within_vector_limits(const Terrain& terrain) {
  if (terrain.layers().size() != 1 || terrain.model() != SurfaceModel::hyperboloid) return false;
  const HeightGrid& grid = *terrain.layers()[0].grid;
  constexpr double kMostPosts = 1 << 30;
  return within_series_limit(terrain) && static_cast<double>(grid.columns) * grid.rows < kMostPosts;
}

}  // namespace terrview

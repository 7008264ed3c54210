#include "ingest/ground_under.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "terrain/mean_heights.h"

namespace terrview {
namespace {

constexpr double kMostSteps = 100;

// The lowest post of the cell and of those about it.
double lowest_post_m(const HeightGrid& grid, glm::ivec2 cell) {
  const glm::ivec2 low = glm::max(cell - 1, glm::ivec2(0));
  const glm::ivec2 high = glm::min(cell + 2, glm::ivec2(grid.columns - 1, grid.rows - 1));
  double lowest_m = std::numeric_limits<double>::infinity();
  for (int row = low.y; row <= high.y; ++row)
    for (int column = low.x; column <= high.x; ++column) {
      const double height_m = grid.at(column, row);
      if (height_m < lowest_m) lowest_m = height_m;
    }
  return lowest_m;
}

class Samples {
 public:
  explicit Samples(const Terrain& terrain) : terrain_(terrain) {}

  // Adds the ground at a point, in the footprint or on its edge.
  void add(glm::dvec2 ground_m, bool inside) {
    const auto ground = terrain_.ground_at(ground_m);
    if (!ground) return;
    const HeightGrid& grid = *terrain_.layers()[static_cast<std::size_t>(ground->grid)].grid;
    lowest_m_ = std::min(lowest_m_, ground->scene_height_m);
    highest_m_ = std::max(highest_m_, ground->scene_height_m);
    foot_m_ = std::min(foot_m_, terrain_.frame().z_scale * lowest_post_m(grid, ground->cell));
    Sum& sum = inside ? inside_ : edge_;
    sum.heights_m += ground->scene_height_m;
    ++sum.count;
  }

  [[nodiscard]] std::optional<GroundUnder> result() const {
    const Sum& sum = inside_.count > 0 ? inside_ : edge_;
    if (sum.count == 0) return std::nullopt;
    return GroundUnder{lowest_m_, sum.heights_m / sum.count, highest_m_, foot_m_};
  }

 private:
  struct Sum {
    double heights_m = 0;
    int count = 0;
  };
  const Terrain& terrain_;
  double lowest_m_ = std::numeric_limits<double>::infinity();
  double highest_m_ = -lowest_m_;
  double foot_m_ = lowest_m_;
  Sum inside_;
  Sum edge_;
};

double finest_post_m(const Terrain& terrain) {
  double finest_m = std::numeric_limits<double>::infinity();
  for (const TerrainLayer& layer : terrain.layers())
    finest_m = std::min(finest_m, post_distance_m(layer));
  return finest_m;
}

}  // namespace

std::optional<GroundUnder> ground_under(const Terrain& terrain, const Polygon& footprint) {
  const glm::dvec2 low = footprint.lowest();
  const glm::dvec2 size = footprint.highest() - low;
  const double step_m = std::max(finest_post_m(terrain) / 2, std::max(size.x, size.y) / kMostSteps);
  Samples samples(terrain);
  const auto vertices = footprint.vertices();
  for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
    const int steps =
        static_cast<int>(std::ceil(glm::distance(vertices[i], vertices[i + 1]) / step_m));
    for (int k = 0; k < std::max(1, steps); ++k)
      samples.add(glm::mix(vertices[i], vertices[i + 1], k / std::max(1.0, double(steps))), false);
  }
  const glm::ivec2 count = glm::ivec2(glm::max(size / step_m, glm::dvec2(4)));
  for (int i = 0; i < count.x; ++i)
    for (int j = 0; j < count.y; ++j) {
      const glm::dvec2 at = low + size * (glm::dvec2(i, j) + 0.5) / glm::dvec2(count);
      if (footprint.contains(at)) samples.add(at, true);
    }
  return samples.result();
}

}  // namespace terrview

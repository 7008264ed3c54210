#include "render/post_sight.h"

#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>

#include <glm/geometric.hpp>

#include "render/parallel.h"
#include "terrain/occlusion.h"
#include "terrain/post_ground.h"

namespace terrview {
namespace {

// Whether the ground stops each of the rays.
using Stopped = std::function<void(std::span<const Ray> rays, std::span<std::uint8_t> stopped)>;

// The line of sight from the eye to an observer; nullopt where nothing can lie between.
std::optional<Ray> line_of_sight(const Terrain& terrain, const HeightGrid& grid,
                                 glm::dvec2 ground_m, double scene_height_m) {
  const double away_m = glm::length(ground_m);
  if (away_m == 0) return std::nullopt;
  double share = 1;
  for (const TerrainLayer& layer : terrain.layers()) {
    if (layer.grid.get() != &grid) continue;
    const double posts_per_m = glm::length(layer.map->jacobian(ground_m) * (ground_m / away_m));
    share = std::min(share, 1 - kStep_cells / (posts_per_m * away_m));
  }
  if (!(share > 0)) return std::nullopt;
  const glm::dvec3 observer_m(ground_m, terrain.frame().at(ground_m).z_m(scene_height_m));
  return Ray{{0, 0, 0}, observer_m, share * glm::length(observer_m)};
}

bool is_under_ground(const Terrain& terrain) {
  const auto ground = terrain.ground_at(glm::dvec2(0));
  return ground && terrain.frame().eye_height_m < ground->scene_height_m;
}

class RowOfPosts {
 public:
  RowOfPosts(const Terrain& terrain, const HeightGrid& grid, const PostSightOptions& options,
             int row)
      : terrain_(terrain), grid_(grid), options_(options), row_(row) {}

  void find(const Stopped& stopped, std::span<std::uint8_t> seen) {
    gather(seen);
    std::vector<std::uint8_t> stops(rays_.size());
    stopped(rays_, stops);
    for (std::size_t i = 0; i < rays_.size(); ++i)
      seen[columns_[i]] = stops[i] == 0 && !meets_object(rays_[i]) ? 1 : 0;
  }

 private:
  void gather(std::span<std::uint8_t> seen) {
    const std::vector<glm::dvec2> ground_m = ground_of_row(terrain_, grid_, row_);
    for (std::size_t i = 0; i < ground_m.size(); ++i) {
      const double height_m = grid_.at(static_cast<int>(i), row_);
      if (std::isnan(height_m) || std::isnan(ground_m[i].x)) continue;
      const auto ray = line_of_sight(terrain_, grid_, ground_m[i],
                                     terrain_.frame().z_scale * height_m + options_.observer_m);
      seen[i] = ray ? 0 : 1;
      if (!ray) continue;
      rays_.push_back(*ray);
      columns_.push_back(i);
    }
  }

  [[nodiscard]] bool meets_object(const Ray& ray) const {
    return options_.objects && options_.objects->stops(ray);
  }

  const Terrain& terrain_;
  const HeightGrid& grid_;
  const PostSightOptions& options_;
  int row_;
  std::vector<Ray> rays_;
  std::vector<std::size_t> columns_;
};

std::vector<std::uint8_t> by_rays(const Terrain& terrain, const HeightGrid& grid,
                                  const PostSightOptions& options, const Stopped& stopped) {
  const auto columns = static_cast<std::size_t>(grid.columns);
  std::vector<std::uint8_t> seen(columns * static_cast<std::size_t>(grid.rows), 0);
  if (is_under_ground(terrain)) return seen;
  parallel_for(grid.rows, options.threads, [&](int row) {
    RowOfPosts(terrain, grid, options, row)
        .find(stopped, std::span(seen).subspan(static_cast<std::size_t>(row) * columns, columns));
  });
  return seen;
}

}  // namespace

std::vector<std::uint8_t> posts_that_see_eye(const Terrain& terrain, const HeightGrid& grid,
                                             const PostSightOptions& options) {
  return by_rays(terrain, grid, options,
                 [&terrain](std::span<const Ray> rays, std::span<std::uint8_t> stopped) {
                   TraceCounts counts;
                   occluded(terrain, rays, stopped, counts);
                 });
}

std::vector<std::uint8_t> posts_that_see_eye_plainly(const Terrain& terrain, const HeightGrid& grid,
                                                     const PostSightOptions& options) {
  return by_rays(terrain, grid, options,
                 [&terrain](std::span<const Ray> rays, std::span<std::uint8_t> stopped) {
                   for (std::size_t i = 0; i < rays.size(); ++i)
                     stopped[i] = terrain.occluded(rays[i]) ? 1 : 0;
                 });
}

}  // namespace terrview

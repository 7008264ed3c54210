#include "render/plan.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "render/meet.h"
#include "render/objects/scene_objects.h"
#include "render/parallel.h"
#include "render/sampling.h"
#include "render/shade.h"
#include "render/shadows.h"
#include "render/water.h"
#include "terrain/grid_walk.h"
#include "terrain/mean_heights.h"

namespace terrview {
namespace {

// Of grid coordinates: far under what a map is off, far above its rounding.
constexpr double kClose_posts = 1e-7;
constexpr int kMostSteps = 30;
// Columns of the lattice that find their ground one from another: a part of a picture begins with
// the first of them, and so finds the same.
constexpr int kRun_px = 64;

// Where a map has (u, v), by Newton's method from a point nearby.
std::optional<glm::dvec2> ground_of(const GroundMap& map, glm::dvec2 uv, glm::dvec2 ground_m) {
  for (int i = 0; i < kMostSteps; ++i) {
    const glm::dvec2 apart = uv - map.to_grid(ground_m);
    if (glm::length(apart) < kClose_posts) return ground_m;
    ground_m += glm::inverse(map.jacobian(ground_m)) * apart;
  }
  return std::nullopt;
}

// The cell of a point that has ground, or one of those that it is on the border of.
std::optional<glm::ivec2> ground_cell(const HeightGrid& grid, glm::dvec2 uv) {
  if (!grid.covers(uv)) return std::nullopt;
  const glm::ivec2 cell = cell_of(grid, uv);
  for (int down = 0; down <= (uv.y == cell.y && cell.y > 0 ? 1 : 0); ++down) {
    for (int left = 0; left <= (uv.x == cell.x && cell.x > 0 ? 1 : 0); ++left)
      if (grid.has_ground(cell.x - left, cell.y - down)) return cell - glm::ivec2(left, down);
  }
  return std::nullopt;
}

// No z lies above.
double highest_m(const Scene& scene) {
  const Terrain& terrain = *scene.terrain;
  double highest = terrain.ceiling_m();
  if (scene.water && scene.water->level_m)
    highest =
        std::max(highest, terrain.frame().ceiling_m(*scene.water->level_m, terrain.reach_m()));
  if (!scene.objects) return highest;
  for (const auto& object : scene.objects->set->objects())
    highest = std::max(highest, object->bounds().highest_m.z);
  return highest;
}

// What a row of pixels shows of one sample each.
struct PlanRow {
  std::vector<int> columns;
  std::vector<Ray> rays;
  RayHits hits;
};

class Plumb {
 public:
  Plumb(const Scene& scene, const PlanLattice& lattice)
      : terrain_(*scene.terrain), lattice_(lattice), above_m_(highest_m(scene) + 1) {}

  [[nodiscard]] PlanRow row(int row, int sample) const {
    PlanRow found;
    glm::dvec2 near_m(0);
    const int before = (lattice_.first_px.x % kRun_px + kRun_px) % kRun_px;
    for (int column = -before; column < lattice_.size_px.x; ++column) {
      const glm::ivec2 pixel = lattice_.first_px + glm::ivec2(column, row);
      if (pixel.x % kRun_px == 0) near_m = glm::dvec2(0);
      const glm::dvec2 image_px = glm::dvec2(pixel) + sample_offset(sample);
      const glm::dvec2 uv = lattice_.corner_uv + lattice_.step_uv * image_px;
      const auto ground_m = ground_of(*terrain_.layers().front().map, uv, near_m);
      if (!ground_m) continue;
      near_m = *ground_m;
      if (column < 0) continue;
      std::optional<Hit> hit = hit_at(uv, *ground_m);
      if (!hit) continue;
      found.columns.push_back(column);
      found.rays.push_back({{*ground_m, above_m_}, {0, 0, -1}});
      found.hits.ground.push_back(hit);
    }
    return found;
  }

 private:
  [[nodiscard]] std::optional<Hit> hit_at(glm::dvec2 uv, glm::dvec2 ground_m) const {
    const HeightGrid& grid = *terrain_.layers().front().grid;
    if (const auto cell = ground_cell(grid, uv)) {
      const double height_m = height_at(grid, terrain_.model(), *cell, uv);
      return hit(ground_m, {terrain_.frame().z_scale * height_m, 0, *cell, uv});
    }
    const auto ground = terrain_.ground_at(ground_m);
    return ground ? std::optional(hit(ground_m, *ground)) : std::nullopt;
  }

  [[nodiscard]] Hit hit(glm::dvec2 ground_m, const Terrain::Ground& ground) const {
    const double z_m = terrain_.frame().at(ground_m).z_m(ground.scene_height_m);
    return {above_m_ - z_m, {ground_m, z_m}, ground.grid, ground.cell, ground.uv};
  }

  const Terrain& terrain_;
  const PlanLattice& lattice_;
  double above_m_;
};

class PlanPicture {
 public:
  PlanPicture(const Scene& scene, const PlanLattice& lattice, const PlanOptions& options)
      : scene_(scene),
        plumb_(scene, lattice),
        samples_(options.samples),
        pixel_{.m = post_distance_m(scene.terrain->layers().front()) *
                    std::sqrt(lattice.step_uv.x * lattice.step_uv.y)},
        frame_{Image(lattice.size_px.x, lattice.size_px.y),
               Raster<char>(lattice.size_px.x, lattice.size_px.y, 0),
               {}} {}

  // On any thread.
  RenderCounts draw(int row) {
    RenderCounts counts;
    std::vector<int> shown(static_cast<std::size_t>(frame_.image.width_px()), 0);
    for (int sample = 0; sample < samples_; ++sample) {
      PlanRow found = plumb_.row(row, sample);
      meet_water(scene_, found.rays, found.hits);
      meet_objects(scene_, found.rays, found.hits, counts.objects);
      ShadowCounts shadows;
      const std::vector<ShadedRay> shaded =
          shade(scene_, {pixel_}, found.rays, found.hits, shadows);
      for (std::size_t i = 0; i < shaded.size(); ++i) {
        const int column = found.columns[i];
        frame_.image.at(column, row) += shaded[i].color;
        ++shown[static_cast<std::size_t>(column)];
        if (sample == 0) frame_.covered.at(column, row) = 1;
      }
      counts.rays += static_cast<std::int64_t>(found.rays.size());
      counts.shadow_rays += shadows.rays;
      counts.shadow_objects += shadows.objects;
    }
    for (int column = 0; column < frame_.image.width_px(); ++column) {
      const int count = shown[static_cast<std::size_t>(column)];
      if (count > 1) frame_.image.at(column, row) /= static_cast<float>(count);
    }
    counts.hits = counts.rays;
    return counts;
  }

  PlanFrame take(const std::vector<RenderCounts>& rows) {
    for (const RenderCounts& row : rows) frame_.counts += row;
    return std::move(frame_);
  }

 private:
  const Scene& scene_;
  Plumb plumb_;
  int samples_;
  PixelWidth pixel_;
  PlanFrame frame_;
};

}  // namespace

PlanFrame render_plan(const Scene& scene, const PlanLattice& lattice, const PlanOptions& options) {
  const std::int64_t pixels = std::int64_t{lattice.size_px.x} * lattice.size_px.y;
  const Scene lit = with_sun_map(scene, pixels, options.threads);
  PlanPicture picture(lit, lattice, options);
  std::vector<RenderCounts> rows(static_cast<std::size_t>(lattice.size_px.y));
  std::atomic<int> done{0};
  parallel_for(lattice.size_px.y, options.threads, [&](int row) {
    rows[static_cast<std::size_t>(row)] = picture.draw(row);
    if (options.progress)
      options.progress(static_cast<double>(++done) / static_cast<double>(lattice.size_px.y));
  });
  return picture.take(rows);
}

}  // namespace terrview

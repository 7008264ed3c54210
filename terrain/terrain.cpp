#include "terrain/terrain.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "terrain/error.h"
#include "terrain/grid_walk.h"
#include "terrain/tracer.h"

namespace terrview {
namespace {

// How far leave() lifts a ray, as a share of the numbers its rounding errors come from: posts
// counted to 1e5 with relief of a kilometre per cell lose 1e-11 of them.
constexpr double kLift = 1e-10;

void check(const HeightGrid& grid, const HeightRange& range) {
  const std::string size = std::to_string(grid.columns) + " x " + std::to_string(grid.rows);
  if (grid.columns < 2 || grid.rows < 2)
    throw InputError("a grid of " + size + " posts has no ground: give one of at least 2 x 2");
  if (std::isnan(range.highest_m))
    throw InputError("a grid of " + size + " posts has no height at all: check its nodata value");
}

// The cell with ground that a point of the grid belongs to: those on a line belong to the cells on
// both sides, as the walks of rays find.
std::optional<glm::ivec2> ground_cell(const HeightGrid& grid, glm::dvec2 uv) {
  const glm::ivec2 last = cell_of(grid, uv);
  const glm::ivec2 first(last.x > 0 && uv.x == last.x ? last.x - 1 : last.x,
                         last.y > 0 && uv.y == last.y ? last.y - 1 : last.y);
  for (int row = last.y; row >= first.y; --row)
    for (int column = last.x; column >= first.x; --column)
      if (grid.has_ground(column, row)) return glm::ivec2(column, row);
  return std::nullopt;
}

void add_work(const TraceCounts& done, TraceCounts* sum) {
  if (!sum) return;
  sum->tests += done.tests;
  sum->nodes += done.nodes;
}

}  // namespace

Terrain::Terrain(std::vector<TerrainLayer> layers, const VerticalFrame& frame, SurfaceModel model,
                 Search search)
    : layers_(std::move(layers)),
      frame_(frame),
      model_(model),
      search_(search),
      reach_m_(0),
      ceiling_m_(-std::numeric_limits<double>::infinity()),
      height_bound_m_(0),
      height_range_m_(std::numeric_limits<double>::infinity(),
                      -std::numeric_limits<double>::infinity()),
      has_holes_(false) {
  for (TerrainLayer& layer : layers_) {
    const HeightRange range = height_range(*layer.grid);
    check(*layer.grid, range);
    reach_m_ = std::max(reach_m_, layer.map->reach_m());
    ceiling_m_ = std::max(ceiling_m_,
                          frame_.ceiling_m(frame_.z_scale * range.highest_m, layer.map->reach_m()));
    for (const double height_m : {range.lowest_m, range.highest_m})
      height_bound_m_ = std::max(height_bound_m_, std::abs(frame_.z_scale * height_m));
    height_range_m_.x = std::min(height_range_m_.x, frame_.z_scale * range.lowest_m);
    height_range_m_.y = std::max(height_range_m_.y, frame_.z_scale * range.highest_m);
    has_holes_ |= range.has_holes;
    if (search == Search::plain) continue;
    if (!layer.ceilings) layer.ceilings = std::make_shared<const HeightCeilings>(*layer.grid);
  }
  const bool holes_matter = layers_.size() > 1 || model == SurfaceModel::band;
  const bool sag_matters = model == SurfaceModel::bilinear && !frame_.is_flat();
  if (skips_blocks() && ((has_holes_ && holes_matter) || sag_matters))
    for (const TerrainLayer& layer : layers_) floors_.emplace_back(*layer.grid);
}

std::optional<Hit> Terrain::first_hit(const Ray& ray, TraceCounts* counts) const {
  const Trace found = trace(*this, ceiling_m_, ray);
  add_work(found.counts, counts);
  if (found.outcome != Outcome::hit) return std::nullopt;
  return found.hit;
}

bool Terrain::occluded(const Ray& ray, TraceCounts* counts) const {
  const Trace found = trace(*this, ceiling_m_, ray);
  add_work(found.counts, counts);
  return found.outcome != Outcome::free;
}

std::optional<Terrain::Ground> Terrain::ground_at(glm::dvec2 ground_m) const {
  for (std::size_t i = 0; i < layers_.size(); ++i) {
    const HeightGrid& grid = *layers_[i].grid;
    const glm::dvec2 uv = layers_[i].map->to_grid(ground_m);
    if (!grid.covers(uv)) continue;
    if (const auto cell = ground_cell(grid, uv))
      return Ground{frame_.z_scale * height_at(grid, model_, *cell, uv), static_cast<int>(i), *cell,
                    uv};
  }
  return std::nullopt;
}

Ray Terrain::leave(const Hit& hit, const glm::dvec3& direction) const {
  glm::dvec3 origin_m = hit.position_m;
  double height_m = 0;
  if (const auto ground = ground_at(glm::dvec2(origin_m))) {
    height_m = ground->scene_height_m;
    origin_m.z = std::max(origin_m.z, frame_.at(glm::dvec2(origin_m)).z_m(height_m));
  }
  origin_m.z += kLift * (std::abs(origin_m.x) + std::abs(origin_m.y) + std::abs(origin_m.z) +
                         std::abs(height_m) + std::abs(frame_.eye_height_m));
  return {origin_m, direction};
}

}  // namespace terrview

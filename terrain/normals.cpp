#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "terrain/terrain.h"

namespace terrview {
namespace {

// The height's difference along one axis at a post: central, or one-sided beside a hole or border.
double slope_at(const HeightGrid& grid, glm::ivec2 post, glm::ivec2 step) {
  const auto height = [&](glm::ivec2 p) {
    const bool inside = p.x >= 0 && p.y >= 0 && p.x < grid.columns && p.y < grid.rows;
    return inside ? static_cast<double>(grid.at(p.x, p.y)) : std::nan("");
  };
  const double here = height(post);
  const double before = height(post - step);
  const double after = height(post + step);
  if (std::isnan(before)) return std::isnan(after) ? 0 : after - here;
  if (std::isnan(after)) return here - before;
  return (after - before) / 2;
}

// dh/du and dh/dv at a post.
glm::dvec2 gradient_at(const HeightGrid& grid, glm::ivec2 post) {
  return {slope_at(grid, post, {1, 0}), slope_at(grid, post, {0, 1})};
}

glm::dvec2 facet_gradient(const HeightGrid& grid, SurfaceModel model, glm::ivec2 cell,
                          glm::dvec2 f) {
  const double nw = grid.at(cell.x, cell.y);
  const double ne = grid.at(cell.x + 1, cell.y);
  const double sw = grid.at(cell.x, cell.y + 1);
  const double se = grid.at(cell.x + 1, cell.y + 1);
  if (model == SurfaceModel::triangles)
    return f.x >= f.y ? glm::dvec2(ne - nw, se - ne) : glm::dvec2(se - sw, sw - nw);
  return {glm::mix(ne - nw, se - sw, f.y), glm::mix(sw - nw, se - ne, f.x)};
}

glm::dvec3 normal_of(glm::dvec2 grid_gradient, const glm::dmat2& jacobian, double z_scale) {
  const glm::dvec2 gradient = z_scale * (glm::transpose(jacobian) * grid_gradient);
  return glm::normalize(glm::dvec3(-gradient.x, -gradient.y, 1));
}

}  // namespace

glm::dvec3 Terrain::facet_normal(const Hit& hit) const {
  const TerrainLayer& layer = layers_[static_cast<std::size_t>(hit.grid)];
  const glm::dvec2 f = glm::clamp(hit.uv - glm::dvec2(hit.cell), 0.0, 1.0);
  return normal_of(facet_gradient(*layer.grid, model_, hit.cell, f),
                   layer.map->jacobian(glm::dvec2(hit.position_m)), frame_.z_scale);
}

glm::dvec3 Terrain::smooth_normal(const Hit& hit) const {
  const TerrainLayer& layer = layers_[static_cast<std::size_t>(hit.grid)];
  const glm::dvec2 f = glm::clamp(hit.uv - glm::dvec2(hit.cell), 0.0, 1.0);
  const glm::dvec2 north = glm::mix(gradient_at(*layer.grid, hit.cell),
                                    gradient_at(*layer.grid, hit.cell + glm::ivec2(1, 0)), f.x);
  const glm::dvec2 south = glm::mix(gradient_at(*layer.grid, hit.cell + glm::ivec2(0, 1)),
                                    gradient_at(*layer.grid, hit.cell + glm::ivec2(1, 1)), f.x);
  return normal_of(glm::mix(north, south, f.y), layer.map->jacobian(glm::dvec2(hit.position_m)),
                   frame_.z_scale);
}

}  // namespace terrview

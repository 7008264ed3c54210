#include <array>
#include <cmath>
#include <cstddef>

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

// That at a place of a cell, between those at its posts.
glm::dvec2 gradient_between(const std::array<glm::dvec2, 4>& at_posts, glm::dvec2 f) {
  const auto& [nw, ne, sw, se] = at_posts;
  return glm::mix(glm::mix(nw, ne, f.x), glm::mix(sw, se, f.x), f.y);
}

// Where no border is near, and NaN where a hole is: the central differences alone.
glm::dvec2 inner_gradient(const HeightGrid& grid, glm::ivec2 cell, glm::dvec2 f) {
  const auto width = static_cast<std::ptrdiff_t>(grid.columns);
  const float* const nw = &grid.heights_m[static_cast<std::size_t>(cell.y * width + cell.x)];
  const auto at_post = [&](std::ptrdiff_t i) {
    const auto half = [&](std::ptrdiff_t step) {
      return (static_cast<double>(nw[i + step]) - static_cast<double>(nw[i - step])) / 2;
    };
    return glm::dvec2(half(1), half(width));
  };
  return gradient_between({at_post(0), at_post(1), at_post(width), at_post(width + 1)}, f);
}

glm::dvec2 smooth_gradient(const HeightGrid& grid, glm::ivec2 cell, glm::dvec2 f) {
  if (cell.x > 0 && cell.y > 0 && cell.x + 2 < grid.columns && cell.y + 2 < grid.rows) {
    const glm::dvec2 inner = inner_gradient(grid, cell, f);
    if (inner == inner) return inner;
  }
  const auto at_post = [&](int column, int row) {
    return gradient_at(grid, cell + glm::ivec2(column, row));
  };
  return gradient_between({at_post(0, 0), at_post(1, 0), at_post(0, 1), at_post(1, 1)}, f);
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
  return normal_of(smooth_gradient(*layer.grid, hit.cell, f),
                   layer.map->jacobian(glm::dvec2(hit.position_m)), frame_.z_scale);
}

}  // namespace terrview

#include "render/cells_in_view.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include <glm/common.hpp>

#include "render/parallel.h"

namespace terrview {
namespace {

// Rays along the longer side of the image.
constexpr int kRays = 64;
// Ground between those rays may lie this much further off, as a share of what they meet.
constexpr int kAround = 8;

CellRect none() {
  return {glm::ivec2(std::numeric_limits<int>::max()), glm::ivec2(std::numeric_limits<int>::min())};
}

CellRect join(const CellRect& a, const CellRect& b) {
  return {glm::min(a.first, b.first), glm::max(a.last, b.last)};
}

}  // namespace

CellRect cells_in_view(const Terrain& terrain, const Camera& camera, int threads) {
  const glm::ivec2 size_px = camera.options().size_px;
  const int step_px = (std::max(size_px.x, size_px.y) + kRays - 1) / kRays;
  const glm::ivec2 count = (size_px + step_px - 1) / step_px;
  std::vector<CellRect> rows(static_cast<std::size_t>(count.y), none());
  parallel_for(count.y, threads, [&](int row) {
    CellRect& cells = rows[static_cast<std::size_t>(row)];
    for (int column = 0; column < count.x; ++column) {
      const glm::dvec2 at_px = (glm::dvec2(column, row) + 0.5) * static_cast<double>(step_px);
      const auto hit = terrain.first_hit(camera.ray(at_px));
      if (hit && hit->grid == 0) cells = join(cells, {hit->cell, hit->cell});
    }
  });
  CellRect cells = none();
  for (const CellRect& row : rows) cells = join(cells, row);
  if (cells.last.x < cells.first.x) return {{0, 0}, {0, 0}};
  const glm::ivec2 around = cells.size() / kAround + 1;
  const HeightGrid& grid = *terrain.layers()[0].grid;
  return {glm::max(cells.first - around, 0),
          glm::min(cells.last + around, glm::ivec2(grid.columns, grid.rows) - 2)};
}

}  // namespace terrview

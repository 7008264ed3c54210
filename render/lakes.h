// Lakes on a grid, by their outlines.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <glm/vec2.hpp>

#include "render/objects/polygon.h"

namespace terrview {

// Calls visit(cell) for every cell of a grid of `grid_size` posts that the polygon's inside
// touches; for some more than once.
void for_each_cell_of(const Polygon& polygon, glm::ivec2 grid_size,
                      const std::function<void(glm::ivec2 cell)>& visit);

// Immutable, so threads may share one.
class Lakes {
 public:
  // `outlines` in grid coordinates.
  Lakes(std::vector<Polygon> outlines, glm::ivec2 grid_size);

  // Whether a point of that cell lies in a lake.
  [[nodiscard]] bool contain(glm::ivec2 cell, glm::dvec2 uv) const;

 private:
  static constexpr std::int32_t kNone = -1;
  static constexpr std::int32_t kSeveral = -2;

  std::vector<Polygon> outlines_;
  int columns_;                      // of cells
  std::vector<std::int32_t> owner_;  // of each cell: the lake that touches it
};

}  // namespace terrview

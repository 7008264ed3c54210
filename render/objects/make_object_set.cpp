#include "render/objects/make_object_set.h"

#include <cstddef>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include "render/objects/cell_map.h"
#include "render/objects/object_bounds.h"
#include "render/objects/rectangle_map.h"

namespace terrview {
namespace {

// Whether the cells of a CellMap would hold few objects each: as many as the average object finds
// in its own.
bool are_even(const std::vector<Box>& boxes) {
  const Box bounds = around(boxes);
  const auto count = static_cast<double>(boxes.size());
  const glm::dvec2 extent_m(bounds.highest_m - bounds.lowest_m);
  const double cell_m = HeightCells::cell_m(extent_m, boxes.size());
  const glm::ivec2 size(extent_m / cell_m);
  std::vector<int> counts(static_cast<std::size_t>(size.x + 1) *
                          static_cast<std::size_t>(size.y + 1));
  double covered = 0;
  for (const Box& box : boxes) {
    const glm::dvec2 wide(glm::dvec2(box.highest_m - box.lowest_m) / cell_m);
    covered += (1 + wide.x) * (1 + wide.y);
    const glm::ivec2 cell(glm::dvec2(box.lowest_m - bounds.lowest_m) / cell_m);
    ++counts[static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(size.x + 1) +
             static_cast<std::size_t>(cell.x)];
  }
  double crowd = 0;
  for (const int objects : counts) crowd += static_cast<double>(objects) * objects;
  constexpr double kMostCells = 16;
  constexpr double kMostInACell = 32;
  return covered <= kMostCells * count && crowd <= kMostInACell * count;
}

}  // namespace

std::unique_ptr<ObjectSet> make_object_set(Objects objects) {
  constexpr std::size_t kFew = 4;
  if (objects.size() <= kFew) return std::make_unique<ObjectList>(std::move(objects));
  if (are_even(bounds_of(objects))) return std::make_unique<CellMap>(std::move(objects));
  return std::make_unique<RectangleMap>(std::move(objects));
}

}  // namespace terrview

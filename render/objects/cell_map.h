// A map of objects by square cells, with the heights of what stands on each.
//
// A ray walks only where it is at the height of objects (height_cells.h) and tests an object in the
// cell in which it enters the object's bounds: no object twice. Borders of cells and bounds are
// passed in the order of one monotonic function (slab_ray.h), so that the map finds what testing
// every object finds, bit for bit, within the limit that rectangle_map.h states. O(n) to build; its
// cells suit objects spread evenly, where it is faster than the rectangle map.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "render/objects/height_cells.h"
#include "render/objects/object_set.h"
#include "render/objects/slab_ray.h"

namespace terrview {

class CellMap : public ObjectSet {
 public:
  // Of at least one object.
  explicit CellMap(Objects objects);

  [[nodiscard]] std::optional<ObjectHit> first_hit(const Ray& ray,
                                                   ObjectCounts* counts = nullptr) const override;
  [[nodiscard]] bool stops(const Ray& ray, ObjectCounts* counts = nullptr) const override;

  // Its own memory, that of the objects aside.
  [[nodiscard]] std::size_t bytes() const;

 private:
  template <class Visit>
  void walk(const Ray& ray, ObjectCounts* counts, const Visit& visit) const;

  // An object over a cell, with its bounds rounded outward.
  struct Entry {
    std::array<Range, 3> range;
    int object;

    [[nodiscard]] Box box() const {
      const auto& [x, y, z] = range;
      return {{x.low_m, y.low_m, z.low_m}, {x.high_m, y.high_m, z.high_m}};
    }
  };

  Box bounds_;
  std::optional<HeightCells> cells_;
  std::vector<int> ends_;  // of the list of each cell
  std::vector<Entry> lists_;
};

}  // namespace terrview

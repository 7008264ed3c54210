// A map of objects that leads each ray from rectangle to rectangle.
//
// The method of chapter 3 of S. Coquillart's thesis (1984), in its other structuring (figure 3-15):
// the bounds of the objects, seen from above, and edges grown from their corners cut the plane into
// rectangles, each with the list of the objects over it and, per side, of its neighbours. A ray
// tests an object in the rectangle in which it enters the object's bounds, and stops where it
// leaves a rectangle behind its nearest hit. (Algorithm 3-1 as printed stops at a hit with whatever
// overlaps the current rectangle, and can miss a nearer object farther on.) The ray walks only
// where it is at the height of objects (height_cells.h).
//
// Borders are integers (rectangle_ranks.h) and a ray passes them in the order of one monotonic
// function (slab_ray.h), so that the map needs no tolerance: it finds what testing every object
// finds, bit for bit. One limit: where rounding puts two lines of an axis at the same distance from
// a far origin, what the ray touches at that distance alone may be missed.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "render/objects/height_cells.h"
#include "render/objects/object_set.h"
#include "render/objects/rectangle_partition.h"
#include "render/objects/rectangle_tiles.h"
#include "render/objects/slab_ray.h"

namespace terrview {

class RectangleMap : public ObjectSet {
 public:
  // Of at least one object, within 1e38 m. O(n log n): where so many overlap that their lists would
  // grow beyond that, neighbours are held as one.
  explicit RectangleMap(Objects objects);

  [[nodiscard]] std::optional<ObjectHit> first_hit(const Ray& ray,
                                                   ObjectCounts* counts = nullptr) const override;
  [[nodiscard]] bool stops(const Ray& ray, ObjectCounts* counts = nullptr) const override;

  [[nodiscard]] std::size_t rectangles() const { return tiles_.tiles.size(); }
  [[nodiscard]] std::size_t empty_rectangles() const;

  // Its own memory, that of the objects aside.
  [[nodiscard]] std::size_t bytes() const;

 private:
  bool build();
  void lay_tiles();

  template <class Visit>
  void walk(const Ray& ray, ObjectCounts* counts, const Visit& visit) const;
  template <class Visit>
  bool meet(const SlabRay& slabs, int over, const Stretch& here, double& leave_m,
            const Visit& visit) const;
  template <class Visit>
  bool meet(const SlabRay& slabs, int group, double& leave_m, const Visit& visit) const;

  Box bounds_;
  std::size_t group_size_ = 1;    // how many objects are held as one
  std::vector<int> order_;        // the objects, group after group
  std::vector<Box> boxes_;        // theirs, in that order
  std::vector<Box> group_boxes_;  // none where each object is a group
  IntLists lists_;                // of groups
  Tiles tiles_;
  std::optional<HeightCells> cells_;
  std::vector<int> tiles_at_;  // the tile at the centre of each cell
};

}  // namespace terrview

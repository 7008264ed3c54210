// Where over the plane a ray is at the height of objects, and which tile is there.
//
// Square cells, about one for each object, with the lowest and the highest point of the objects
// over each, and a pyramid of them (as Tevs, Ihrke & Seidel, I3D 2008, walk heights): what the ray
// passes over or under is skipped in steps as large as can be.
#pragma once

#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include "render/objects/rectangle_tiles.h"
#include "render/objects/slab_ray.h"

namespace terrview {

class RectangleCells {
 public:
  RectangleCells(const std::vector<Box>& boxes, const Box& bounds, const std::vector<Tile>& tiles);

  [[nodiscard]] std::size_t bytes() const;

 private:
  friend class CellWalk;

  // Heights; none where low_m > high_m.
  using Heights = Range;

  struct Level {
    glm::ivec2 size;
    std::vector<Heights> heights_m;  // by row
  };

  [[nodiscard]] double border_m(int axis, int border) const {
    return low_m_[axis] + border * cell_m_;
  }
  [[nodiscard]] int near(int axis, double at_m) const;
  [[nodiscard]] glm::ivec2 cells_over(int axis, double low_m, double high_m) const;
  void raise(const Box& box);
  void add_level();
  void place(const std::vector<Tile>& tiles);

  glm::dvec2 low_m_;
  double cell_m_;
  std::vector<Level> levels_;  // the cells first
  std::vector<int> tiles_;     // by row of cells: the tile at the centre of each
};

// One ray's walk over the cells.
class CellWalk {
 public:
  CellWalk(const RectangleCells& cells, const SlabRay& slabs, double from_m);

  // The next stretch, up to leave_m, of the ray within one cell and between its heights. Every
  // point of a box within its cells' heights is on one.
  [[nodiscard]] std::optional<Stretch> next(double leave_m);

  // A tile at or near the last stretch.
  [[nodiscard]] int tile() const { return tile_; }

 private:
  [[nodiscard]] double border_m(int axis, int border) const;
  [[nodiscard]] int cell_at(int axis, double distance_m, int low, int high) const;
  void leave_block(int axis, double at_m);

  const RectangleCells& cells_;
  const SlabRay& slabs_;
  glm::ivec2 at_;
  double at_m_;
  std::size_t level_ = 0;
  int tile_ = 0;
};

}  // namespace terrview

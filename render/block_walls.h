// The cut faces of a block of ground: vertical walls from every edge of it down to a plinth.
//
// A wall stands on each edge of a cell that has ground on one side alone: along the outermost
// posts, and about whatever has no data, so that open voids are holes through the block with walls
// of their own. Its upper edge is the line between the two posts, which is the ground's there under
// every surface model. Where another layer goes on just outside there is no wall, and where layers
// end on one line there is that of the preferred one.
//
// Walls are met from outside alone, and reach over the ground by kOver of the numbers that their
// place is made of, several times the rounding of either: no ray slips between them and the ground
// (tests/render/block_walls_test.cpp).
#pragma once

#include <memory>
#include <vector>

#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>

#include "render/objects/object.h"
#include "terrain/terrain.h"

namespace terrview {

class BlockWalls final : public Object {
 public:
  enum Part { kFace, kLine };  // lines run along the upper and the lower edge

  static constexpr double kOver = 1e-10;

  // `plinth_z_m` in the view frame, below all ground; `line_m` is a line's height. The Earth is
  // flat.
  BlockWalls(std::shared_ptr<const Terrain> terrain, double plinth_z_m, double line_m);

  [[nodiscard]] Box bounds() const override;
  [[nodiscard]] std::optional<SurfaceHit> first_hit(const Ray& ray) const override;

 private:
  struct Walls {
    const HeightGrid* grid;
    glm::dvec2 origin_uv;  // below the eye
    glm::dmat2 jacobian;
    // Whether any wall stands on a line of the grid: one of equal u, one of equal v.
    std::vector<char> across_u;
    std::vector<char> across_v;
  };
  class Crossing;

  // Whether a layer has no wall at a place on its edge; `outward_m` leads to just outside.
  [[nodiscard]] bool covered(std::size_t layer, const glm::dvec2& ground_m,
                             const glm::dvec2& outward_m) const;
  // Of a ray whose direction is of unit length.
  [[nodiscard]] std::optional<SurfaceHit> first_crossing(std::size_t layer, int axis,
                                                         const Ray& ray) const;

  std::shared_ptr<const Terrain> terrain_;
  double plinth_z_m_;
  double top_z_m_;
  double line_m_;
  std::vector<Walls> layers_;
};

}  // namespace terrview

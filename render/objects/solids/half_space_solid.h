// All that lies behind a plane.
#pragma once

#include "render/objects/ray_range.h"
#include "render/objects/solids/solid.h"

namespace terrview {

class HalfSpaceSolid final : public Solid {
 public:
  // The points with dot(normal, point) <= offset; the normal need not have unit length. Throws
  // InputError unless it has a length.
  explicit HalfSpaceSolid(const HalfSpace& half);

  // Finite only where the normal lies along an axis, and there on one side.
  [[nodiscard]] Box bounds() const override;
  void append_crossings(const Line& line, Crossings& crossings) const override;

 private:
  HalfSpace half_;  // of a unit normal
};

}  // namespace terrview

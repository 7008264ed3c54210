// A polygon raised from the plane z = 0.
#pragma once

#include "render/objects/polygon.h"
#include "render/objects/solids/solid.h"

namespace terrview {

// Watertight, as the polygon is (polygon.h). Concave ones, and ones with holes, are entered and
// left several times.
class PrismSolid final : public Solid {
 public:
  // Throws InputError unless the polygon has an area and the height is above 0.
  PrismSolid(Polygon base, double height_m);

  [[nodiscard]] Box bounds() const override;
  void append_crossings(const Line& line, Crossings& crossings) const override;

 private:
  void cross_sides(const Line& line, Polygon::Crossings& sides) const;
  [[nodiscard]] glm::dvec3 side_normal(std::size_t edge, const Line& line, bool enters) const;

  Polygon base_;
  double height_m_;
};

}  // namespace terrview

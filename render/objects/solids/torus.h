// A ring about the z axis, round in section.
#pragma once

#include "render/objects/solids/solid.h"

namespace terrview {

struct TorusShape {
  double major_radius_m;  // from the axis to the middle of the section
  double minor_radius_m;  // of the section
};

// Hits are right to a few roundings of the coordinates, however thin the ring is: the quartic only
// parts the roots, each of which is then found on the distance to the surface.
class Torus final : public Solid {
 public:
  // Throws InputError unless 0 < minor radius < major radius.
  explicit Torus(const TorusShape& shape);

  [[nodiscard]] Box bounds() const override;
  void append_crossings(const Line& line, Crossings& crossings) const override;

 private:
  [[nodiscard]] double outside_m(const glm::dvec3& at_m) const;
  [[nodiscard]] glm::dvec3 normal(const glm::dvec3& at_m) const;

  TorusShape shape_;
};

}  // namespace terrview

// A solid moved, turned, stretched or sheared.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include "render/objects/solids/solid.h"

namespace terrview {

// The t of crossings is that of the line it is given.
class Transformed final : public Solid {
 public:
  // `to_parent` takes the solid's points to those of this one. Throws InputError unless it is
  // affine (its last row 0 0 0 1) and can be inverted.
  Transformed(SolidPtr solid, const glm::dmat4& to_parent);

  [[nodiscard]] Box bounds() const override;
  [[nodiscard]] int parts() const override { return solid_->parts(); }
  void append_crossings(const Line& line, Crossings& crossings) const override;

 private:
  SolidPtr solid_;
  glm::dmat3 to_parent_;
  glm::dvec3 shift_m_;
  glm::dmat3 to_solid_;
  glm::dmat3 normal_to_parent_;
  double stretch_;   // by how much to_solid_ makes a vector longer, at most
  double rounding_;  // what it loses of a vector's size
};

}  // namespace terrview

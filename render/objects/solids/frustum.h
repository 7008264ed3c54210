// A cylinder, a cone or a cone without its top: upright on the origin.
#pragma once

#include "render/objects/ray_range.h"
#include "render/objects/solids/solid.h"

namespace terrview {

struct FrustumShape {
  double base_radius_m;  // at z = 0
  double top_radius_m;   // at z = height_m: that of the base for a cylinder, 0 for a cone
  double height_m;
};

class Frustum final : public Solid {
 public:
  // Throws InputError unless the height and one of the radii are above 0, and the other not below.
  explicit Frustum(const FrustumShape& shape);

  [[nodiscard]] Box bounds() const override;
  void append_crossings(const Line& line, Crossings& crossings) const override;

 private:
  // The quadratic in t that is negative inside of the cone of the side and of its mirror image.
  struct Quadratic;

  [[nodiscard]] RayRange within_side(const Line& line) const;
  [[nodiscard]] glm::dvec3 side_normal(const glm::dvec3& at_m) const;

  FrustumShape shape_;
  double taper_;  // growth of the radius with z
};

}  // namespace terrview

// A sphere.
#pragma once

#include <optional>

#include <glm/vec3.hpp>

#include "render/objects/object.h"

namespace terrview {

// Distances are right to 1e-15 of the coordinates' size, and of its square root for rays that
// graze.
class Sphere : public Object {
 public:
  Sphere(const glm::dvec3& centre_m, double radius_m);

  [[nodiscard]] Box bounds() const override { return bounds_; }
  [[nodiscard]] std::optional<SurfaceHit> first_hit(const Ray& ray) const override;

 private:
  glm::dvec3 centre_m_;
  double radius_m_;
  Box bounds_;
};

}  // namespace terrview

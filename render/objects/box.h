// A box along the axes: the upright prism over a rectangle.
#pragma once

#include <optional>

#include "render/objects/object.h"

namespace terrview {

// Hits are exact on their face, and agree with the slab test of its bounds (slab_ray.h).
class BoxObject : public Object {
 public:
  // The parts of hits.
  enum Face { west, east, south, north, bottom, top };

  explicit BoxObject(const Box& box) : box_(box) {}

  [[nodiscard]] Box bounds() const override { return box_; }
  [[nodiscard]] std::optional<SurfaceHit> first_hit(const Ray& ray) const override;
  [[nodiscard]] bool stops(const Ray& ray) const override;

 private:
  Box box_;
};

}  // namespace terrview

// A solid as an object of a scene. The parts of hits are the primitives of its tree.
#pragma once

#include "render/objects/object.h"
#include "render/objects/solids/solid.h"

namespace terrview {

class SolidObject final : public Object {
 public:
  // The solid stands in the view frame. Throws InputError unless it has finite bounds with
  // something in them.
  explicit SolidObject(SolidPtr solid);

  [[nodiscard]] Box bounds() const override { return bounds_; }
  // From within the solid, where the ray leaves it.
  [[nodiscard]] std::optional<SurfaceHit> first_hit(const Ray& ray) const override;

 private:
  SolidPtr solid_;
  Box bounds_;
};

}  // namespace terrview

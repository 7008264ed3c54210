// A sphere about the origin.
#pragma once

#include "render/objects/solids/solid.h"

namespace terrview {

class SphereSolid final : public Solid {
 public:
  // Throws InputError unless the radius is above 0.
  explicit SphereSolid(double radius_m);

  [[nodiscard]] Box bounds() const override;
  void append_crossings(const Line& line, Crossings& crossings) const override;

 private:
  double radius_m_;
};

}  // namespace terrview

// A box along the axes.
#pragma once

#include "render/objects/solids/solid.h"

namespace terrview {

class BoxSolid final : public Solid {
 public:
  // Throws InputError unless every side of the box has a length.
  explicit BoxSolid(const Box& box);

  [[nodiscard]] Box bounds() const override { return box_; }
  void append_crossings(const Line& line, Crossings& crossings) const override;

 private:
  Box box_;
};

}  // namespace terrview

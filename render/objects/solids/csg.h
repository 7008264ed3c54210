// Constructive solid geometry: a union, intersection or difference of two solids.
//
// The crossings of a line with the two are merged in order, and kept where the operator says that
// the line passes from outside to inside of the result or back. Surfaces that coincide count as
// one: two crossings, one of each side, whose bounds of error meet are passed together, if nothing
// lies between them. So A - A is empty, A + A is A, and no gap or skin is seen between bodies that
// touch.
#pragma once

#include "render/objects/solids/solid.h"

namespace terrview {

enum class CsgOperator { add, intersect, subtract };

// Whether a point is in the result, by the table of the operator.
[[nodiscard]] constexpr bool is_inside(CsgOperator op, bool in_left, bool in_right) {
  if (op == CsgOperator::add) return in_left || in_right;
  return in_left && (op == CsgOperator::intersect ? in_right : !in_right);
}

// Parts are numbered through the left side, then the right. Where surfaces coincide, that of the
// left is seen.
class CsgSolid final : public Solid {
 public:
  CsgSolid(CsgOperator op, SolidPtr left, SolidPtr right);

  [[nodiscard]] Box bounds() const override { return bounds_; }
  [[nodiscard]] int parts() const override { return parts_; }
  // Asks a side nothing where the line misses the box of what can matter of it, nor the right where
  // the left is empty and that decides.
  void append_crossings(const Line& line, Crossings& crossings) const override;

 private:
  void append_merged(std::size_t first, std::size_t middle, std::size_t last,
                     Crossings& crossings) const;

  CsgOperator op_;
  SolidPtr left_;
  SolidPtr right_;
  int left_parts_;
  int parts_;
  Box left_box_;   // of what can matter of the left
  Box right_box_;  // and of the right
  Box bounds_;
};

}  // namespace terrview

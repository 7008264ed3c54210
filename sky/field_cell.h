// One cell of a random field, which divides itself: what a painter that stops at other levels in
// other places goes by. Cells are divided in four, so the field's levels along x and y are equal.
//
// The values are those of field_part() of a field with as many levels as the cell.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "sky/random_field.h"

namespace terrview {

// Which cell: column and row in cells of its level.
struct CellPlace {
  int level = 0;
  std::int64_t column = 0;
  std::int64_t row = 0;

  // One of the four that it is divided into: south-west, south-east, north-west, north-east.
  [[nodiscard]] CellPlace child(int k) const {
    return {level + 1, 2 * column + (k & 1), 2 * row + (k >> 1)};
  }
};

// Draws of one level around a cell.
class CellDraws {
 public:
  CellDraws(const RandomField& field, int level, std::int64_t row)
      : random_(field.random()),
        deviation_(field.deviation(level)),
        key_(random_.row_key(level, row)) {}

  [[nodiscard]] float first(std::int64_t column) const {
    return deviation_ * random_.first(KeyedRandom::bits(key_, column));
  }
  [[nodiscard]] float second(std::int64_t column) const {
    return deviation_ * random_.second(KeyedRandom::bits(key_, column));
  }

 private:
  const KeyedRandom& random_;
  float deviation_;
  std::uint64_t key_;
};

// A cell of kind midpoint or displaced: the values of its corners, south-west, south-east,
// north-west, north-east.
template <FieldKind kKind>
class FieldCell {
 public:
  FieldCell() = default;
  [[nodiscard]] static FieldCell root(const RandomField& field, const CellPlace& at);
  [[nodiscard]] std::array<FieldCell, 4> divided(const RandomField& field,
                                                 const CellPlace& at) const;
  [[nodiscard]] const std::array<float, 4>& corners() const { return corners_; }

 private:
  explicit FieldCell(const std::array<float, 4>& corners) : corners_(corners) {}

  std::array<float, 4> corners_;
};

// A cell of kind smooth: the control points of the cells around it and its own, row by row.
template <>
class FieldCell<FieldKind::smooth> {
 public:
  FieldCell() = default;
  [[nodiscard]] static FieldCell root(const RandomField& field, const CellPlace& at);
  [[nodiscard]] std::array<FieldCell, 4> divided(const RandomField& field,
                                                 const CellPlace& at) const;
  [[nodiscard]] std::array<float, 4> corners() const {
    const auto corner = [&](std::size_t k) {
      return mean(points_[k], points_[k + 1], points_[k + 3], points_[k + 4]);
    };
    return {corner(0), corner(1), corner(3), corner(4)};
  }

 private:
  std::array<float, 9> points_;
};

}  // namespace terrview

// A rectangle of a random field's vertices, made at once: the fast form.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sky/random_field.h"

namespace terrview {

// Vertices of a level: columns [column, column + columns), rows [row, row + rows), counted from the
// origin; vertex (0, 0) is a corner of root cells. Rows run north.
struct LatticeRectangle {
  std::int64_t column = 0;
  std::int64_t row = 0;
  std::int64_t columns = 0;
  std::int64_t rows = 0;

  [[nodiscard]] std::size_t size() const {
    return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  }
};

// The field's values on vertices of its last level, row by row from the south. The work is O(size):
// each level is made from the one before it, over the part that matters. Whatever the rectangle, a
// vertex gets the same bytes.
[[nodiscard]] std::vector<float> field_part(const RandomField& field,
                                            const LatticeRectangle& rectangle);

}  // namespace terrview

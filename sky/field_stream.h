// A random field one smallest cell at a time, in memory that grows with a side of the region, not
// with its area (S. Coquillart, thesis, 1984, chapter 4, 2.2).
//
// Regions are divided recursively, south-west, south-east, north-west and north-east in turn. A
// vertex or an edge is made when it is first used, shared by the regions beside it, never made
// again, and freed after its last use. Dividing one root cell n times along both axes, at most
//   2^(n+1) + 3n - 1 vertices and 2^(n+2) + 10n - 6 edges (n >= 3)
// live at once, and no fewer; the work is O(4^n).
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

#include <glm/vec2.hpp>

#include "sky/random_field.h"

namespace terrview {

struct FieldVertex {
  // Counted in vertices of the last level from the origin.
  std::int64_t column;
  std::int64_t row;
  float value;
};

// A cell of the last level.
struct FieldCorners {
  FieldVertex south_west;
  FieldVertex south_east;
  FieldVertex north_west;
  FieldVertex north_east;
};

// The most that lived at once.
struct StreamCounts {
  std::size_t vertices = 0;
  std::size_t edges = 0;
};

// Calls `take` with every smallest cell of a root cell. The field is one of kind midpoint; its
// values are those of field_part().
StreamCounts stream_root_cell(const RandomField& field, const glm::i64vec2& root_cell,
                              const std::function<void(const FieldCorners&)>& take);

}  // namespace terrview

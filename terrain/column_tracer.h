// Exact vertical coherence: image columns that are vertical planes.
//
// The rays of such a column share their ground line and differ in slope alone, so they meet the
// ground at distances that grow with the slope (Coquillart 1984, chapter 2, 4.1, property 1): one
// walk outward serves the whole column, each ray going on where the one below it ended. Several
// columns walk in the lanes of a vector, in double precision and with the arithmetic of the plain
// walk, so the hits are the same to the bit, under every instruction set.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "terrain/eye_front.h"
#include "terrain/terrain.h"

namespace terrview {

// Rays from the eye: that of pixel (i, j) has the direction (across[i], rise[j]).
struct ColumnView {
  std::vector<glm::dvec2> across;
  std::vector<double> rise;  // by falling value: row 0 is the top of the picture
};

// A hit on the way along a ground line; turned into a Hit by column_hit().
struct ColumnHit {
  double g_m = -1;  // along the ground; negative = a miss
  glm::dvec2 uv;
  glm::ivec2 cell;
};

// Whether trace_columns() serves this terrain: within_vector_limits().
[[nodiscard]] bool has_columns(const Terrain& terrain);

// Traces the columns first ... first + count - 1 of `view`, in any number of calls. hits[i * rows +
// j] is pixel (first + i, j). Adds to `counts`.
void trace_columns(const Terrain& terrain, const ColumnView& view, int first, int count,
                   std::span<ColumnHit> hits, TraceCounts& counts);

// The same by the front of a view: sooner, because hidden ground is not walked.
void trace_columns(const EyeFront& front, const ColumnView& view, int first, int count,
                   std::span<ColumnHit> hits, TraceCounts& counts);

// The Hit that Terrain::first_hit() gives for pixel (column, row).
[[nodiscard]] Hit column_hit(const ColumnView& view, int column, int row, const ColumnHit& hit);

}  // namespace terrview

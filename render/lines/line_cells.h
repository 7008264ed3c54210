// The lines that pass through the squares between pixels' centres.
#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "render/lines/line_tracer.h"
#include "render/lines/polyline.h"

namespace terrview {

struct GridLineOptions {
  int step_posts = 0;      // between lines; 0: a power of two, by distance, as there is room for
  double spacing_px = 20;  // the least room between such lines on ground seen from above
  double least_px = 1.5;   // lines closer than this, on ground seen at a low angle, are left out
};

// The squares whose upper left corners are the points (i, row), 0 <= i < columns, of the lattice of
// pixels' centres from (-1, -1) on, so that lines reach the picture's borders. `upper` and `lower`
// are what its columns + 1 points of that row and the next show.
//
// An outline passes from side to side of a square where LineTracer::crossing() finds it. A line of
// the grid passes where u or v, linear along sides, is a multiple of the step, as far as the
// outlines that cut the square.
[[nodiscard]] std::vector<LineSegment> row_segments(const LineTracer& tracer, int row,
                                                    const std::vector<LinePoint>& upper,
                                                    const std::vector<LinePoint>& lower,
                                                    const GridLineOptions& options);

// Point (i, row) of the lattice.
[[nodiscard]] glm::dvec2 lattice_px(int column, int row);

}  // namespace terrview

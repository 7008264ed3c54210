// Palettes that need no search.
#pragma once

#include "quantize/color_cells.h"

namespace terrview {

// A fixed table: the 2^p <= `colors` colours whose components are spread evenly from 0 to 255,
// green the finest and blue the coarsest (4-4-4 bits for 4096 colours, 3-3-2 for 256). It suits
// every picture and fits none.
[[nodiscard]] Palette fixed_palette(int colors);

// Heckbert's popularity algorithm: the colours that most pixels have, counted in cubes of five bits
// a component (or as many more as `colors` need), each as the mean of its pixels.
[[nodiscard]] Palette popular_colors(const ColorCounts& counts, int colors);

}  // namespace terrview

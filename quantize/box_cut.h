// Palettes by cutting the box of all colours into boxes, one a colour.
#pragma once

#include "quantize/color_cells.h"

namespace terrview {

enum class BoxCut {
  // P. Heckbert, "Color image quantization for frame buffer display", SIGGRAPH 1982: the box of
  // most
  // pixels is cut across its longest side at the median of its pixels.
  median,
  // X. Wu, "Efficient statistical computations for optimal color quantization", Graphics Gems II
  // (1991): the box of the greatest error is cut where the errors of the two parts (sums of squared
  // distances from the mean) have the least sum. Wu's table of moments has 33^3 entries; here the
  // planes of the box's own cells are summed, at their full precision.
  variance,
};

// At most `colors` colours, each the mean of its box; of at least one cell.
[[nodiscard]] Palette cut_boxes(const ColorCells& cells, int colors, BoxCut cut);

}  // namespace terrview

// A palette for a picture, and the address of each of its colours.
#pragma once

#include <string>

#include "quantize/color_counts.h"
#include "quantize/color_map.h"
#include "quantize/nearest_color.h"

namespace terrview {

enum class PaletteMethod {
  tree,          // the colour tree, its leaves means, deleted by error
  thesis,        // the colour tree as it was: quantize/color_tree.h
  fixed,         // the same table for every picture
  popularity,    // the colours that most pixels have
  median_cut,    // Heckbert's
  variance_cut,  // Wu's
};

// Of PaletteMethod::tree.
enum class TreeOrder { preorder, population, error };

// How a pixel's address is found: `leaf` takes the leaf of the tree that the pixel's colour leads
// to, the others the nearest colour of the palette.
enum class Match { leaf, rgb, oklab, ciede2000 };

struct QuantizeOptions {
  int colors = 256;  // at most; 1 to 65536
  PaletteMethod method = PaletteMethod::tree;
  TreeOrder order = TreeOrder::error;
  Match match = Match::leaf;  // without a tree, rgb
};

struct Quantizer {
  Palette palette;
  ColorMap::Find find;
};

// Of a picture of at least one pixel.
[[nodiscard]] Quantizer make_quantizer(const ColorCounts& counts, const QuantizeOptions& options);

// With a palette that is already there.
[[nodiscard]] Quantizer make_quantizer(Palette palette, Match match);

}  // namespace terrview

// The colour tree with what a picture's statistics add to it.
//
// The tree of triplets (quantize/color_tree.h) holds every colour of the picture, its leaves keep
// the mean of their pixels, and siblings are deleted where that costs least, instead of in
// pre-order: first those whose parent has the fewest pixels, or the least error (the sum of the
// squared distances of its pixels from their mean). Neither is ever smaller in a parent than in its
// children, so one sort gives the order. Of the last family only as many children are merged as
// needed, so no address is left unused.
//
// Promises, each a test in tests/quantize/pruned_tree_test.cpp:
//   1. There are N colours, or as many as the picture has.
//   2. Every colour is the rounded mean of the pixels that have its address.
//   3. The addresses depend on how often each colour occurs alone.
#pragma once

#include <cstdint>
#include <vector>

#include "quantize/color_cells.h"

namespace terrview {

enum class DeletionOrder { population, error };

// The colours from `first` (triplets) to the next interval's have this address.
struct AddressInterval {
  std::uint32_t first;
  std::uint32_t address;
};

class PrunedTree {
 public:
  // For at most `max_colors` colours, 1 to 65536, of at least one.
  PrunedTree(const ColorCells& cells, int max_colors, DeletionOrder order);

  [[nodiscard]] const Palette& palette() const { return palette_; }

  // Of a colour of the picture; of another, that of a leaf before it.
  [[nodiscard]] std::uint32_t address(Rgb8 color) const;

 private:
  std::vector<AddressInterval> leaves_;  // in the order of triplets
  Palette palette_;
};

}  // namespace terrview

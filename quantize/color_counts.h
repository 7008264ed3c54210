// How often each colour occurs in a picture: what palettes are chosen from.
//
// A picture may come in any pieces and any order. Memory is bounded: at most 64 MiB, 16 KiB for
// each group of 4096 like colours that occurs.
#pragma once

#include <cstdint>
#include <span>

#include "quantize/color_grid.h"

namespace terrview {

class ColorCounts {
 public:
  void add(std::span<const Rgb8> colors);

  [[nodiscard]] bool empty() const { return empty_; }

  // Calls visit(triplets, count) for every colour that occurs, in the order of triplets. A count
  // beyond 2^32 - 1 stays there.
  template <class Visit>
  void for_each(const Visit& visit) const {
    counts_.for_each(visit);
  }

 private:
  ColorGrid<std::uint32_t> counts_;
  bool empty_ = true;
};

}  // namespace terrview

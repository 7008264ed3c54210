#include "quantize/color_counts.h"

namespace terrview {

void ColorCounts::add(std::span<const Rgb8> colors) {
  empty_ = empty_ && colors.empty();
  for (const Rgb8 color : colors) {
    std::uint32_t& count = counts_.at(triplets(color));
    count += count != 0xFFFFFFFF ? 1 : 0;
  }
}

}  // namespace terrview

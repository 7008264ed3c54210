// Addresses of colours, each looked for once.
#pragma once

#include <cstdint>
#include <functional>
#include <utility>

#include "quantize/color_grid.h"

namespace terrview {

class ColorMap {
 public:
  using Find = std::function<std::uint32_t(Rgb8)>;

  // `find` gives the address of a colour, below 65536, always the same.
  explicit ColorMap(Find find) : find_(std::move(find)) {}

  [[nodiscard]] std::uint16_t address(Rgb8 color) {
    std::uint32_t& known = addresses_.at(triplets(color));
    if (known == 0) known = find_(color) + 1;
    return static_cast<std::uint16_t>(known - 1);
  }

 private:
  Find find_;
  ColorGrid<std::uint32_t> addresses_;  // plus one; 0 is not known yet
};

}  // namespace terrview

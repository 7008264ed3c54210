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
    std::uint16_t& known = following_.at(triplets(color));
    if (known == 0) known = static_cast<std::uint16_t>(find_(color) + 1);
    return static_cast<std::uint16_t>(known - 1);
  }

 private:
  Find find_;
  // The address plus one; 0 is not known yet. That of 65535 wraps to 0 and is found every time.
  ColorGrid<std::uint16_t> following_;
};

}  // namespace terrview

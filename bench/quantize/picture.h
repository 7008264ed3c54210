// A picture in memory, and a picture rewritten with a palette.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "quantize/color.h"

namespace terrview {

struct Picture {
  std::string name;
  int width_px = 0;
  int height_px = 0;
  std::vector<Rgb8> pixels;  // row by row
};

struct Rewritten {
  Palette palette;
  std::vector<std::uint16_t> indices;
};

}  // namespace terrview

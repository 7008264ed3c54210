#pragma once

#include <cmath>

#include "render/color_ramp.h"
#include "render/image.h"

namespace terrview {

// Peak signal to noise, dB, in sRGB; infinite for equal pictures.
[[nodiscard]] inline double psnr_db(const Image& a, const Image& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      const double step = to_srgb(a.pixels()[i][c]) - to_srgb(b.pixels()[i][c]);
      sum += step * step;
    }
  }
  return -10 * std::log10(sum / (3 * static_cast<double>(a.pixels().size())));
}

}  // namespace terrview

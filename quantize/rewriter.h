// Pictures rewritten as addresses of a palette, line by line from the top.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quantize/color_map.h"

namespace terrview {

enum class Dither {
  none,
  // Floyd & Steinberg, "An adaptive algorithm for spatial grey scale" (1976): 7, 3, 5 and 1
  // sixteenths of the error of a pixel go to its neighbours; every other line runs backwards.
  diffusion,
  // Bayer, "An optimum method for two-level rendition of continuous-tone pictures" (1973): a tile
  // of 8 x 8 thresholds, as wide as the palette's colours are apart. Every pixel depends on its own
  // place and colour alone.
  ordered,
};

class Rewriter {
 public:
  // Lines of `width_px` pixels.
  Rewriter(Palette palette, ColorMap::Find find, Dither dither, int width_px);

  // The next line. `indices` is as long as `colors`. Pixels whose `valid` is 0 get `nodata`, and no
  // error goes to or through them; an empty `valid` means that all are valid.
  void rewrite(std::span<const Rgb8> colors, std::span<const std::uint8_t> valid,
               std::uint16_t nodata, std::span<std::uint16_t> indices);

 private:
  using Error = glm::ivec3;  // in sixteenths of a component's step

  void map(std::span<const Rgb8> colors, std::span<std::uint16_t> indices);
  void diffuse(std::span<const Rgb8> colors, std::span<const std::uint8_t> valid,
               std::span<std::uint16_t> indices);
  void order(std::span<const Rgb8> colors, std::span<std::uint16_t> indices);

  Palette palette_;
  ColorMap map_;
  Dither dither_;
  int line_ = 0;
  double spread_ = 0;               // of the ordered thresholds
  std::vector<Error> errors_;       // of this line; a pixel at either end belongs to nobody
  std::vector<Error> next_errors_;  // of the next
};

}  // namespace terrview

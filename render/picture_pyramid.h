// A picture and its halves, filtered at any place and width.
//
// Places are pixels from the picture's upper left corner: the first pixel's centre is (0.5, 0.5).
// Beyond the picture and in its holes there is nothing, towards which colours fade over a pixel.
#pragma once

#include <vector>

#include <glm/fwd.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "render/image.h"

namespace terrview {

class PicturePyramid {
 public:
  // sRGB, and 255 in alpha, or 0 in a hole.
  explicit PicturePyramid(Raster<glm::u8vec4> picture);

  [[nodiscard]] glm::ivec2 size_px() const {
    return {levels_.front().width_px(), levels_.front().height_px()};
  }

  // Linear Rec. 709 times the share of the picture, and that share, bilinear at the picture's own
  // pixels (level 0) and between two halvings else: at `level` pixels are 2^level wide.
  [[nodiscard]] glm::vec4 at(glm::dvec2 place_px, double level) const;

  // The mean over the parallelogram that two sides in pixels span about a place, by as many places
  // along its longer axis as the axes differ by, up to kMostPlaces.
  [[nodiscard]] glm::vec4 mean(glm::dvec2 place_px, const glm::dmat2& sides_px) const;

  static constexpr int kMostPlaces = 16;

 private:
  [[nodiscard]] glm::vec4 bilinear(std::size_t level, glm::dvec2 place_px) const;

  std::vector<Raster<glm::u8vec4>> levels_;  // sRGB and alpha, each half of the one before
};

}  // namespace terrview

// Haze: a blur that grows with distance (Coquillart 1984, chapter 1, 6, proposed the filter).
#pragma once

#include <optional>

#include <glm/vec2.hpp>

#include "render/image.h"
#include "render/sampling.h"
#include "render/scene.h"

namespace terrview {

// The blur of a picture of which `base` holds the rays through the pixels' centres.
//
// A Gaussian of standard deviation haze_px_per_m * distance, cut off at two of them and at 16
// pixels. Ground weighs less the more its distance differs, and nothing beyond a fifth: what lies
// nearer never bleeds into what lies further, nor back. The background takes no part.
class Haze {
 public:
  // No pixel depends on one that is further off, along rows or columns.
  static constexpr int kReach_px = 18;

  // `base` must outlive it.
  Haze(const Air& air, const Raster<Sample>& base) : per_m_(air.haze_px_per_m), base_(base) {}

  // The colour of a ray through `pixel`.
  [[nodiscard]] glm::vec3 blurred(glm::ivec2 pixel, const Sample& sample) const;

  // The colour of a pixel that was not traced.
  [[nodiscard]] glm::vec3 filled(glm::ivec2 pixel) const;

  // Whether a pixel between those of even column and row is left to the blur: all of those beside
  // it are ground of nearly the same distance, blurred by a pixel or more.
  [[nodiscard]] bool fills(glm::ivec2 pixel) const;

 private:
  struct Sum {
    glm::vec3 color{0, 0, 0};
    float weight = 0;
  };

  [[nodiscard]] Sum around(glm::ivec2 pixel, float distance_m) const;
  // The mean distance of the even pixels beside `pixel`; nullopt where it is not to be filled.
  [[nodiscard]] std::optional<float> distance_beside(glm::ivec2 pixel) const;

  double per_m_;
  const Raster<Sample>& base_;
};

}  // namespace terrview

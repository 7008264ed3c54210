// A cloud layer's field in perspective, by subdivision (Coquillart 1984, chapter 4, 3.3.1-3.3.3).
//
// Root cells in sight are divided until they are small in the picture; a cell outside the window is
// left, one inside it is not compared any more, one that is cut goes on. The image M' of an edge's
// middle follows from those of its ends, U' and V', and of the edge's point at infinity L' by the
// harmonic division (U', V', M', L') = -1. With w = 1 / |U' L'| as a weight for each end this is
//   M' = (w_U U' + w_V V') / (w_U + w_V),
// two divisions, whatever the direction, also where L' itself is at infinity. The weight is that of
// homogeneous coordinates: w_M is the mean of w_U and w_V, and w U' that of their first two.
//
// A cell is small when it is under `leaf_px` pixels across, measured the shorter way (its image's
// area over its longest edge), so that the far clouds do not alias. Where the layer is a plane
// every cell is projected so; on a shell those of the first divisions are projected one by one,
// after which cells are flat to 1e-5 of their side.
//
// value() makes the same by itself for one pixel, from its root cell down: it agrees with paint()
// bit for bit. Both differ from the field divided to its last level as docs/skies.md says.
#pragma once

#include <limits>
#include <vector>

#include <glm/vec2.hpp>

#include "sky/cloud_layer.h"
#include "sky/random_field.h"
#include "sky/sky_camera.h"

namespace terrview {

struct CloudSample {
  float value = std::numeric_limits<float>::quiet_NaN();  // of the field; NaN: no layer there
  float distance_m = 0;                                   // along the line of sight
};

// A rectangle of pixels, and which of them matter, row by row.
struct PixelWindow {
  glm::ivec2 first_px{0, 0};
  glm::ivec2 size_px{0, 0};
  std::vector<bool> wanted;
};

class CloudPainter {
 public:
  // The field has the same levels along x and y.
  CloudPainter(const RandomField& field, const CloudLayer& layer, const SkyCamera& camera,
               double leaf_px = 1);

  // Windows of at most this side keep a cylinder's columns flat; they begin at its multiples.
  static constexpr int kWindow_px = 64;

  // The samples of the wanted pixels of a window, row by row.
  [[nodiscard]] std::vector<CloudSample> paint(const PixelWindow& window) const;

  // One pixel, by itself.
  [[nodiscard]] CloudSample value(const glm::ivec2& pixel) const;

 private:
  // The perspective view of a pixel's window.
  [[nodiscard]] SkyCamera facing(int column_px) const;

  const RandomField& field_;
  CloudLayer layer_;
  SkyCamera camera_;
  double leaf_px_;
};

}  // namespace terrview

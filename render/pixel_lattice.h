// Image points in columns and rows, and the rays through them where columns are upright.
#pragma once

#include <optional>

#include <glm/vec2.hpp>

#include "render/camera.h"
#include "terrain/column_tracer.h"

namespace terrview {

// Point (i, j) is first_px + step_px * (i, j).
struct PixelLattice {
  glm::dvec2 first_px{0.5, 0.5};
  int step_px = 1;
  glm::ivec2 count;

  [[nodiscard]] glm::dvec2 at(glm::ivec2 point) const {
    return first_px + static_cast<double>(step_px) * glm::dvec2(point);
  }
};

// The lattice of the centres of the camera's pixels.
[[nodiscard]] PixelLattice pixel_centres(const Camera& camera);

// The camera's rays through a lattice column by column, where columns of the image are vertical
// planes through the eye.
[[nodiscard]] std::optional<ColumnView> column_view(const Camera& camera,
                                                    const PixelLattice& lattice);
[[nodiscard]] inline std::optional<ColumnView> column_view(const Camera& camera) {
  return column_view(camera, pixel_centres(camera));
}

}  // namespace terrview

// A cell of the cloud layer as the picture shows it.
#pragma once

#include <array>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "sky/cloud_layer.h"
#include "sky/field_cell.h"
#include "sky/sky_camera.h"

namespace terrview {

// Where a point shows: (x, y) / w in pixels; w > 0 in front of the eye.
struct ImagePoint {
  double x;
  double y;
  double w;
};

// The image of the middle of an edge, by the harmonic division with the edge's point at infinity.
[[nodiscard]] inline ImagePoint harmonic_middle(const ImagePoint& a, const ImagePoint& b) {
  return {(a.x + b.x) * 0.5, (a.y + b.y) * 0.5, (a.w + b.w) * 0.5};
}

// From the layer to the picture of a perspective camera.
class LayerImage {
 public:
  LayerImage(const CloudLayer& layer, const SkyCamera& camera) : layer_(layer), camera_(camera) {}

  // Of a place in root cells.
  [[nodiscard]] ImagePoint at(const glm::dvec2& place) const;
  // Of the corner (column, row) of cells of a level.
  [[nodiscard]] ImagePoint corner(int level, std::int64_t column, std::int64_t row) const;
  // Whether the cells of a level are so flat that the middles of their edges follow from their
  // ends.
  [[nodiscard]] bool is_flat(int level) const {
    return layer_.curvature_per_m == 0 || level >= kFlatLevel;
  }

 private:
  static constexpr int kFlatLevel = 4;

  CloudLayer layer_;
  SkyCamera camera_;
};

// South-west, south-east, north-west, north-east.
using ImageCell = std::array<ImagePoint, 4>;

[[nodiscard]] ImageCell root_image(const LayerImage& image, const CellPlace& at);
[[nodiscard]] std::array<ImageCell, 4> divided_image(const LayerImage& image, const CellPlace& at,
                                                     const ImageCell& cell);

// Whether a cell, wholly before the eye, is under `leaf_px` across, the shorter way.
[[nodiscard]] bool is_small(const ImageCell& cell, double leaf_px);

// A rectangle of the picture, in pixels.
struct ImageWindow {
  glm::dvec2 first;
  glm::dvec2 last;
};

enum class Within { outside, cut, inside };
// `outside` and `inside` are certain, `cut` may be either.
[[nodiscard]] Within compare(const ImageCell& cell, const ImageWindow& window);

// The smallest window around a cell that lies before the eye.
[[nodiscard]] ImageWindow bounds(const ImageCell& cell);

}  // namespace terrview

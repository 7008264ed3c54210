// The colours of what rays meet.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "render/camera.h"
#include "render/meet.h"
#include "render/scene.h"
#include "render/shadows.h"

namespace terrview {

// What one ray shows.
struct ShadedRay {
  glm::vec3 color{0, 0, 0};  // clear * transmission + air * (1 - transmission)
  // From the ray's origin, in the view frame; infinite where nothing is hit.
  float distance_m = std::numeric_limits<float>::infinity();
  glm::vec3 clear{0, 0, 0};   // without the air; the background's where nothing is hit
  glm::vec3 air{0, 0, 0};     // the air's colour there
  float transmission = 1;     // 1 where nothing is hit
  glm::vec3 normal{0, 0, 0};  // as Terrain's normals; 0 where nothing is hit
};

// How wide a pixel is on what its ray meets.
struct PixelWidth {
  double rad = 0;  // of rays that part
  double m = 0;    // of parallel rays

  [[nodiscard]] double at(double distance_m) const { return m + rad * distance_m; }
};
[[nodiscard]] PixelWidth pixel_width(const Camera& camera);

// By what way rays come, and how wide pixels are on what they show.
struct RayWidths {
  PixelWidth pixel;
  std::span<const double> before_m = {};  // of each ray, up to its origin; empty: 0
  int bounces = 0;                        // of materials, before

  [[nodiscard]] double at(std::size_t ray, double distance_m) const {
    return pixel.at(distance_m + (before_m.empty() ? 0 : before_m[ray]));
  }
};

// The colours of the rays of a block, whose hits are given, all its shadow rays together. Water
// mirrors what is there to mirror once: of water in a mirror the body is seen. Adds to `counts`.
[[nodiscard]] std::vector<ShadedRay> shade(const Scene& scene, const RayWidths& widths,
                                           std::span<const Ray> rays, const RayHits& hits,
                                           ShadowCounts& counts);

}  // namespace terrview

// How much of the sun comes through the clouds to a point of the ground.
#pragma once

#include <glm/vec3.hpp>

#include "sky/sky_painter.h"

namespace terrview {

// The clouds are those of SkyPainter's picture, divided down to cells of about 50 m: finer ones the
// sun's disc blurs. Immutable.
class CloudShadows {
 public:
  CloudShadows(const Clouds& clouds, const glm::dvec3& towards_sun);

  // 1 under clear sky, down to kDarkest under thick clouds. `point_m` in the frame of the layer:
  // the eye's east-north-up. A sun under kLowest_rad casts shadows as if it stood there.
  [[nodiscard]] float share(const glm::dvec3& point_m) const;

  static constexpr float kDarkest = 0.2F;
  static constexpr double kLowest_rad = 0.05;

 private:
  CloudLayer layer_;
  ColorTable table_;
  glm::dvec3 towards_sun_;
  RandomField field_;
  double addresses_per_unit_;
};

}  // namespace terrview

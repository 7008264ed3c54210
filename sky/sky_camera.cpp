#include "sky/sky_camera.h"

#include <cmath>

namespace terrview {

glm::dvec3 SkyCamera::direction(const glm::dvec2& image_px) const {
  const double across_px = image_px.x - size_px.x / 2.0;
  const double up_px = size_px.y / 2.0 - image_px.y;
  if (!cylindrical) return forward * focal_px + right * across_px + up * up_px;
  const double turn_rad = across_px / focal_px;
  return (forward * std::cos(turn_rad) + right * std::sin(turn_rad)) * focal_px + up * up_px;
}

SkyCamera SkyCamera::facing(double column_px) const {
  if (!cylindrical) return *this;
  SkyCamera flat = *this;
  const double turn_rad = (column_px - size_px.x / 2.0) / focal_px;
  flat.cylindrical = false;
  flat.forward = forward * std::cos(turn_rad) + right * std::sin(turn_rad);
  flat.right = right * std::cos(turn_rad) - forward * std::sin(turn_rad);
  return flat;
}

}  // namespace terrview

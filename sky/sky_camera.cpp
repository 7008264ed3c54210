#include "sky/sky_camera.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace terrview {

glm::dvec3 SkyCamera::direction(const glm::dvec2& image_px) const {
  const double across_px = image_px.x - middle_px.x;
  const double up_px = middle_px.y - image_px.y;
  if (!cylindrical) return forward * focal_px + right * across_px + up * up_px;
  const double turn_rad = across_px / focal_px;
  return (forward * std::cos(turn_rad) + right * std::sin(turn_rad)) * focal_px + up * up_px;
}

glm::dvec2 SkyCamera::image_of(const glm::dvec3& direction) const {
  const double ahead = glm::dot(direction, forward);
  const double aside = glm::dot(direction, right);
  const double above = glm::dot(direction, up);
  if (!cylindrical)
    return {middle_px.x + focal_px * aside / ahead, middle_px.y - focal_px * above / ahead};
  return {middle_px.x + focal_px * std::atan2(aside, ahead),
          middle_px.y - focal_px * above / std::hypot(ahead, aside)};
}

SkyCamera SkyCamera::facing(double column_px) const {
  if (!cylindrical) return *this;
  SkyCamera flat = *this;
  const double turn_rad = (column_px - middle_px.x) / focal_px;
  flat.cylindrical = false;
  flat.middle_px.x = column_px;
  flat.forward = forward * std::cos(turn_rad) + right * std::sin(turn_rad);
  flat.right = right * std::cos(turn_rad) - forward * std::sin(turn_rad);
  return flat;
}

}  // namespace terrview

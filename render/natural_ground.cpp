#include "render/natural_ground.h"

#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "render/color_ramp.h"

namespace terrview {
namespace {

constexpr double kDegrees = std::numbers::pi / 180;

float share_between(double low, double high, double x) {
  return static_cast<float>(glm::smoothstep(low, high, x));
}

}  // namespace

glm::vec3 natural_color(const NaturalGround& ground, double height_m, double slope_rad) {
  static const glm::vec3 kMeadow = from_srgb8(92, 120, 62);
  static const glm::vec3 kPasture = from_srgb8(122, 132, 84);
  static const glm::vec3 kScree = from_srgb8(142, 135, 124);
  static const glm::vec3 kRock = from_srgb8(116, 111, 107);
  static const glm::vec3 kSnow = from_srgb8(240, 243, 248);
  const double above_m = height_m - ground.snow_line_m;
  const double steeper = (slope_rad - ground.rock_slope_rad) / kDegrees;
  glm::vec3 color = glm::mix(kMeadow, kPasture, share_between(-2000, -900, above_m));
  color = glm::mix(color, kScree, share_between(-900, -100, above_m));
  color = glm::mix(color, kRock, share_between(-8, 8, steeper));
  const float snow = share_between(-300, 300, above_m) * (1 - share_between(3, 20, steeper));
  return glm::mix(color, kSnow, snow);
}

double slope_of(const glm::dvec3& normal, double z_scale) {
  return std::atan2(glm::length(glm::dvec2(normal)), normal.z * z_scale);
}

}  // namespace terrview

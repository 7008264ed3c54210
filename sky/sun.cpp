#include "sky/sun.h"

#include <cmath>
#include <numbers>

namespace terrview {
namespace {

constexpr double kObliquity_rad = 23.44 * std::numbers::pi / 180;

}  // namespace

SunPosition sun_position(double latitude_rad, double declination_rad, double hour_angle_rad) {
  const double east = -std::cos(declination_rad) * std::sin(hour_angle_rad);
  const double north =
      std::cos(latitude_rad) * std::sin(declination_rad) -
      std::sin(latitude_rad) * std::cos(declination_rad) * std::cos(hour_angle_rad);
  const double up = std::sin(latitude_rad) * std::sin(declination_rad) +
                    std::cos(latitude_rad) * std::cos(declination_rad) * std::cos(hour_angle_rad);
  double azimuth_rad = std::atan2(east, north);
  if (azimuth_rad < 0) azimuth_rad += 2 * std::numbers::pi;
  return {azimuth_rad, std::atan2(up, std::hypot(east, north))};
}

SunPosition summer_afternoon(double latitude_rad) {
  const double declination_rad = latitude_rad < 0 ? -kObliquity_rad : kObliquity_rad;
  return sun_position(latitude_rad, declination_rad, std::numbers::pi / 4);
}

glm::dvec3 towards(const SunPosition& sun) {
  const double run = std::cos(sun.elevation_rad);
  return {run * std::sin(sun.azimuth_rad), run * std::cos(sun.azimuth_rad),
          std::sin(sun.elevation_rad)};
}

}  // namespace terrview

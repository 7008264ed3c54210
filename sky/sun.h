// The sun's place in the sky.
#pragma once

#include <glm/vec3.hpp>

namespace terrview {

struct SunPosition {
  double azimuth_rad;    // clockwise from true north
  double elevation_rad;  // of the centre, without refraction
};

// From the sun's declination and hour angle (positive after noon) at a latitude.
[[nodiscard]] SunPosition sun_position(double latitude_rad, double declination_rad,
                                       double hour_angle_rad);

// Three in the afternoon, local solar time, on the longest day of the latitude's summer: 21 June in
// the north; 21 December in the south.
[[nodiscard]] SunPosition summer_afternoon(double latitude_rad);

// The unit vector towards the sun, east-north-up.
[[nodiscard]] glm::dvec3 towards(const SunPosition& sun);

}  // namespace terrview

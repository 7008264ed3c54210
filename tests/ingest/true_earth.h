// The Earth without approximations: geocentric coordinates of the WGS 84 ellipsoid in long double,
// by their textbook formula, sharing nothing with the project.
#pragma once

#include <cmath>

#include <GeographicLib/Geocentric.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace terrview::true_earth {

using Real = long double;

inline constexpr Real kRadians = 0.017453292519943295769L;

struct Place {
  double latitude_deg;
  double longitude_deg;
  double height_m;
};

struct Vector {
  Real x, y, z;
};

inline Vector geocentric(const Place& place) {
  const Real a = 6378137;
  const Real f = 1 / 298.257223563L;
  const Real e2 = f * (2 - f);
  const Real lat = place.latitude_deg * kRadians;
  const Real lon = place.longitude_deg * kRadians;
  const Real n = a / std::sqrt(1 - e2 * std::sin(lat) * std::sin(lat));
  const Real flat = (n + place.height_m) * std::cos(lat);
  return {flat * std::cos(lon), flat * std::sin(lon),
          (n * (1 - e2) + place.height_m) * std::sin(lat)};
}

// East, north, up at `eye` of a point.
inline glm::dvec3 enu(const Place& eye, const Place& point) {
  const Vector from = geocentric(eye);
  const Vector to = geocentric(point);
  const Vector d{to.x - from.x, to.y - from.y, to.z - from.z};
  const Real lat = eye.latitude_deg * kRadians;
  const Real lon = eye.longitude_deg * kRadians;
  const Real outward = d.x * std::cos(lon) + d.y * std::sin(lon);
  return {static_cast<double>(-d.x * std::sin(lon) + d.y * std::cos(lon)),
          static_cast<double>(d.z * std::cos(lat) - outward * std::sin(lat)),
          static_cast<double>(d.z * std::sin(lat) + outward * std::cos(lat))};
}

// The place of a point given by east, north, up at `eye`.
inline Place place(const Place& eye, const glm::dvec3& enu_m) {
  const Vector from = geocentric(eye);
  const Real lat = eye.latitude_deg * kRadians;
  const Real lon = eye.longitude_deg * kRadians;
  const Real outward = enu_m.z * std::cos(lat) - enu_m.y * std::sin(lat);
  Place result{};
  GeographicLib::Geocentric::WGS84().Reverse(
      static_cast<double>(from.x + outward * std::cos(lon) - enu_m.x * std::sin(lon)),
      static_cast<double>(from.y + outward * std::sin(lon) + enu_m.x * std::cos(lon)),
      static_cast<double>(from.z + enu_m.y * std::cos(lat) + enu_m.z * std::sin(lat)),
      result.latitude_deg, result.longitude_deg, result.height_m);
  return result;
}

inline double angle_rad(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

}  // namespace terrview::true_earth

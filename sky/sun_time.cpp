#include "sky/sun_time.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <libnova/libnova.h>

namespace terrview {
namespace {

constexpr double kRadians = std::numbers::pi / 180;
constexpr double kArcseconds = kRadians / 3600;

// Of the longitude of the sun at one astronomical unit.
constexpr double kAberration = 20.4898 * kArcseconds;
constexpr double kParallax = 8.794 * kArcseconds;

// General precession in longitude since J2000 (Lieske 1977).
double precession_rad(double julian_day) {
  const double centuries = (julian_day - 2451545) / 36525;
  return (5029.0966 + 1.11113 * centuries) * centuries * kArcseconds;
}

struct Equatorial {
  double right_ascension_rad;
  double declination_rad;
};

Equatorial from_ecliptic(double longitude_rad, double latitude_rad, double obliquity_rad) {
  const double sine = std::sin(obliquity_rad);
  const double cosine = std::cos(obliquity_rad);
  return {std::atan2(std::sin(longitude_rad) * cosine - std::tan(latitude_rad) * sine,
                     std::cos(longitude_rad)),
          std::asin(std::sin(latitude_rad) * cosine +
                    std::cos(latitude_rad) * sine * std::sin(longitude_rad))};
}

}  // namespace

SunPosition sun_at(double julian_day, const SunPlace& place) {
  const double dynamical_day = ln_get_jde(julian_day);
  // libnova's apparent place is of J2000 and lacks aberration, its apparent sidereal time takes
  // the nutation along the ecliptic: only the parts are used.
  ln_helio_posn sun{};
  ln_get_solar_geom_coords(dynamical_day, &sun);
  ln_nutation nutation{};
  ln_get_nutation(dynamical_day, &nutation);
  const double obliquity_rad = (nutation.ecliptic + nutation.obliquity) * kRadians;
  const double shift_rad = nutation.longitude * kRadians;
  const Equatorial equatorial = from_ecliptic(
      sun.L * kRadians + precession_rad(dynamical_day) + shift_rad - kAberration / sun.R,
      sun.B * kRadians, obliquity_rad);
  const double sidereal_rad =
      ln_get_mean_sidereal_time(julian_day) * 15 * kRadians + shift_rad * std::cos(obliquity_rad);
  SunPosition position =
      sun_position(place.latitude_rad, equatorial.declination_rad,
                   sidereal_rad + place.longitude_rad - equatorial.right_ascension_rad);
  position.elevation_rad -= kParallax / sun.R * std::cos(position.elevation_rad);
  return position;
}

Atmosphere atmosphere_at(double height_m) {
  constexpr double kTropopause_m = 11000;
  const double h = std::min(height_m, kTropopause_m);
  return {1013.25 * std::pow(1 - 2.25577e-5 * h, 5.25588), 15 - 0.0065 * h};
}

double refraction_rad(double elevation_rad, const Atmosphere& air) {
  const double elevation_deg = std::max(elevation_rad / kRadians, -1.0);
  const double arcminutes =
      1.02 / std::tan((elevation_deg + 10.3 / (elevation_deg + 5.11)) * kRadians);
  return arcminutes / 60 * kRadians * (air.pressure_hpa / 1010) * (283 / (273 + air.temperature_c));
}

}  // namespace terrview

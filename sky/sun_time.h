// Where the sun stands at a date, through libnova.
//
// Within 0.004 degrees of NREL's Solar Position Algorithm from 1910 to 2110 (I. Reda & A. Andreas,
// Solar Energy 76(5), 2004; tests/sky/sun_time_test.cpp).
#pragma once

#include "sky/sun.h"

namespace terrview {

struct SunPlace {
  double latitude_rad;
  double longitude_rad;  // east
};

// The sun's centre without refraction, parallax included. `julian_day` counts days of UTC: noon of
// 1 January 2000 is 2451545.
[[nodiscard]] SunPosition sun_at(double julian_day, const SunPlace& place);

struct Atmosphere {
  double pressure_hpa = 1013.25;
  double temperature_c = 15;
};

// That of the International Standard Atmosphere.
[[nodiscard]] Atmosphere atmosphere_at(double height_m);

// How much refraction lifts a body that would stand at `elevation_rad` without it (G. G. Bennett's
// formula, inverted by T. Saemundsson: Meeus, Astronomical Algorithms, 16.4). Below -1 degree,
// where nothing is seen, as at -1 degree.
[[nodiscard]] double refraction_rad(double elevation_rad, const Atmosphere& air);

}  // namespace terrview

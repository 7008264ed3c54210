#include "cli/view_light.h"

#include <cmath>
#include <numbers>

#include "render/daylight.h"
#include "render/shadows.h"
#include "sky/sun_time.h"
#include "terrain/error.h"

namespace terrview {
namespace {

constexpr double kRadians = std::numbers::pi / 180;
// Where nothing tells the latitude, the sun is that of the middle latitudes.
constexpr double kUnknownLatitude_rad = 45 * kRadians;
// The convention of shaded relief: light from the upper left of a map.
constexpr SunPosition kReliefLight{315 * kRadians, 45 * kRadians};

SunPosition without_refraction(const LightOptions& light, const SunSeenFrom& eye) {
  if (light.sun) return *light.sun;
  if (light.relief) return kReliefLight;
  if (light.time) {
    if (!eye.place)
      throw InputError(
          "--time: the DEM has no coordinate system, so nothing tells where the eye is: give --sun "
          "AZ,EL, or the system with --a-srs EPSG:CODE");
    return sun_at(*light.time,
                  {eye.place->latitude_deg * kRadians, eye.place->longitude_deg * kRadians});
  }
  return summer_afternoon(eye.place ? eye.place->latitude_deg * kRadians : kUnknownLatitude_rad);
}

// Infinite where there is no air.
double visibility_m(const AirOptions& air) {
  if (air.extinction_per_km) return 1000 * kExtinctionTimesVisibility / *air.extinction_per_km;
  return 1000 * air.visibility_km.value_or(kUsualVisibility_km);
}

}  // namespace

void check_light(const LightOptions& light) {
  if (light.sun && std::abs(light.sun->elevation_rad) > 90 * kRadians)
    throw InputError("--sun: the elevation is beyond 90 degrees: the order is AZ,EL");
  if (light.no_shadows && light.soft_shadows)
    throw InputError("--soft-shadows: there are none with --no-shadows: leave one of them out");
  if (light.relief && light.soft_shadows)
    throw InputError("--soft-shadows: --shade relief casts no shadows: leave one of them out");
}

void check_air(const AirOptions& air) {
  if (air.extinction_per_km && !(*air.extinction_per_km >= 0))
    throw InputError("--extinction: give a number per kilometre, 0 for no air");
  if (air.haze_px < 0 || air.haze_px > 100)
    throw InputError("--haze: give pixels from 0 to 100 (1 is a fair haze)");
  if (air.haze_px > 0 && !std::isfinite(visibility_m(air)))
    throw InputError("--haze: is measured at the visibility: give one with --visibility KM");
}

SunPosition resolve_sun(const LightOptions& light, const SunSeenFrom& eye) {
  SunPosition sun = without_refraction(light, eye);
  if (light.refracted_sun)
    sun.elevation_rad += refraction_rad(sun.elevation_rad, atmosphere_at(eye.height_m));
  return sun;
}

bool casts_shadows(const LightOptions& light) { return !light.no_shadows && !light.relief; }

void set_light(const LightOptions& light, const SunPosition& sun, Scene& scene) {
  const Daylight day = daylight(sun.elevation_rad);
  scene.light.towards_sun = towards(sun);
  scene.light.sun = day.sun;
  scene.light.ambient = day.ambient;
  scene.light.casts_shadows = casts_shadows(light);
  if (light.soft_shadows) scene.light.sun_radius_rad = kSunRadius_rad;
  scene.sky = day.sky;
}

Air make_air(const AirOptions& options) {
  Air air;
  const double range_m = visibility_m(options);
  air.extinction_per_m = kExtinctionTimesVisibility / range_m;
  air.haze_px_per_m = options.haze_px / range_m;
  air.color = options.color;
  air.sunward = options.sunward;
  return air;
}

}  // namespace terrview

#include "render/air.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/painted_sky.h"

namespace terrview {
namespace {

glm::vec3 with_sunward(const glm::vec3& color, const std::optional<glm::vec3>& sunward,
                       const Light& light, const glm::dvec3& direction) {
  if (!sunward) return color;
  // All of it at the sun, none behind.
  const double half = (1 + glm::dot(direction, light.towards_sun)) / 2;
  return glm::mix(color, *sunward, static_cast<float>(half * half * half * half));
}

}  // namespace

float transmission(const Air& air, double distance_m) {
  return static_cast<float>(std::exp(-air.extinction_per_m * distance_m));
}

glm::vec3 air_color(const Scene& scene, const glm::dvec3& direction) {
  const Air& air = scene.air;
  const bool of_the_sky = !air.color && !air.sunward;
  if (of_the_sky && scene.painted_sky) return scene.painted_sky->horizon_color(direction);
  return with_sunward(air.color.value_or(scene.sky.horizon),
                      of_the_sky ? scene.sky.sunward : air.sunward, scene.light, direction);
}

glm::vec3 background_color(const Scene& scene, const glm::dvec3& direction, bool from_eye) {
  if (direction.z < 0) return air_color(scene, direction);
  if (scene.painted_sky)
    return from_eye ? scene.painted_sky->color(direction)
                    : scene.painted_sky->clear_color(direction);
  const SkyGradient& sky = scene.sky;
  const glm::vec3 horizon = with_sunward(sky.horizon, sky.sunward, scene.light, direction);
  // Steep at the horizon, as the air's depth is.
  const double below = 1 - direction.z;
  return glm::mix(sky.zenith, horizon, static_cast<float>(below * below * below));
}

}  // namespace terrview

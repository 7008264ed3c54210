#include "render/daylight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/exponential.hpp>

namespace terrview {
namespace {

struct SkyAt {
  float elevation_deg;
  glm::vec3 ambient;
  glm::vec3 horizon;
  glm::vec3 zenith;
  glm::vec3 sunward;
};

// By falling sun. Chosen by eye after photographs, in linear Rec. 709.
constexpr std::array kSkies{
    SkyAt{20, {.23F, .26F, .31F}, {.56F, .68F, .82F}, {.08F, .20F, .52F}, {.64F, .71F, .80F}},
    SkyAt{5, {.17F, .19F, .25F}, {.55F, .60F, .68F}, {.07F, .16F, .42F}, {.95F, .71F, .44F}},
    SkyAt{0, {.11F, .12F, .18F}, {.36F, .36F, .44F}, {.05F, .10F, .28F}, {.92F, .44F, .16F}},
    SkyAt{-6, {.028F, .031F, .052F}, {.07F, .08F, .14F}, {.012F, .025F, .08F}, {.42F, .13F, .05F}},
    SkyAt{-12,
          {.004F, .005F, .009F},
          {.008F, .012F, .028F},
          {.003F, .005F, .015F},
          {.03F, .016F, .018F}},
    SkyAt{-18,
          {.0012F, .0015F, .0025F},
          {.003F, .004F, .008F},
          {.002F, .003F, .007F},
          {.003F, .004F, .008F}},
};

SkyAt sky_at(float elevation_deg) {
  if (elevation_deg >= kSkies.front().elevation_deg) return kSkies.front();
  for (std::size_t i = 1; i < kSkies.size(); ++i) {
    const SkyAt& high = kSkies[i - 1];
    const SkyAt& low = kSkies[i];
    if (elevation_deg < low.elevation_deg) continue;
    const float share =
        (elevation_deg - low.elevation_deg) / (high.elevation_deg - low.elevation_deg);
    return {elevation_deg, glm::mix(low.ambient, high.ambient, share),
            glm::mix(low.horizon, high.horizon, share), glm::mix(low.zenith, high.zenith, share),
            glm::mix(low.sunward, high.sunward, share)};
  }
  return kSkies.back();
}

// How much air the light of the sun crosses, in that overhead.
double air_mass(double elevation_deg) {
  const double h = std::max(elevation_deg, 0.0);
  return 1 / (std::sin(h * std::numbers::pi / 180) + 0.50572 * std::pow(h + 6.07995, -1.6364));
}

glm::vec3 sun_color(double elevation_deg) {
  const glm::vec3 overhead(1.02F, 0.98F, 0.91F);
  const glm::vec3 depth(0.05F, 0.085F, 0.16F);  // optical, of the air overhead
  const double rising = std::clamp((elevation_deg + 3) / 3, 0.0, 1.0);
  return static_cast<float>(rising) * overhead *
         glm::exp(-depth * static_cast<float>(air_mass(elevation_deg) - 1));
}

}  // namespace

Daylight daylight(double elevation_rad) {
  const double elevation_deg = elevation_rad * 180 / std::numbers::pi;
  const SkyAt sky = sky_at(static_cast<float>(elevation_deg));
  return {sun_color(elevation_deg), sky.ambient, {sky.horizon, sky.zenith, sky.sunward}};
}

}  // namespace terrview

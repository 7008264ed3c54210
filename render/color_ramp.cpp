#include "render/color_ramp.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

namespace terrview {
namespace {

float to_linear(float srgb) {
  return srgb <= 0.04045F ? srgb / 12.92F : std::pow((srgb + 0.055F) / 1.055F, 2.4F);
}

}  // namespace

glm::vec3 from_srgb8(float red, float green, float blue) {
  return {to_linear(red / 255), to_linear(green / 255), to_linear(blue / 255)};
}

float to_srgb(float linear) {
  const float x = std::clamp(linear, 0.0F, 1.0F);
  return x <= 0.0031308F ? 12.92F * x : 1.055F * std::pow(x, 1 / 2.4F) - 0.055F;
}

glm::vec3 ColorRamp::at(double height_m) const {
  const auto above =
      std::lower_bound(stops.begin(), stops.end(), height_m,
                       [](const ColorStop& stop, double height) { return stop.height_m < height; });
  const bool exact = above != stops.end() && above->height_m == height_m;
  if (exact) return above->color;
  switch (interpolation) {
    case RampInterpolation::exact:
      return fallback;
    case RampInterpolation::discrete:
      return above == stops.end() ? fallback : above->color;
    case RampInterpolation::linear:
    case RampInterpolation::nearest:
      break;
  }
  if (stops.empty()) return fallback;
  if (above == stops.begin()) return above->color;
  const auto below = std::prev(above);
  if (above == stops.end()) return below->color;
  const double share = (height_m - below->height_m) / (above->height_m - below->height_m);
  if (interpolation == RampInterpolation::nearest) return share < 0.5 ? below->color : above->color;
  return glm::mix(below->color, above->color, static_cast<float>(share));
}

const ColorRamp& altitude_tints() {
  static const ColorRamp ramp{.stops = {{-100, from_srgb8(87, 128, 122)},
                                        {0, from_srgb8(96, 138, 96)},
                                        {200, from_srgb8(112, 150, 88)},
                                        {500, from_srgb8(140, 164, 94)},
                                        {800, from_srgb8(170, 176, 104)},
                                        {1100, from_srgb8(192, 180, 116)},
                                        {1500, from_srgb8(190, 160, 108)},
                                        {2000, from_srgb8(172, 138, 104)},
                                        {2600, from_srgb8(160, 140, 124)},
                                        {3200, from_srgb8(186, 180, 176)},
                                        {4000, from_srgb8(232, 232, 234)},
                                        {6000, from_srgb8(250, 250, 252)}}};
  return ramp;
}

}  // namespace terrview

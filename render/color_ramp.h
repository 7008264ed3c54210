// Colours by altitude.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace terrview {

enum class RampInterpolation {
  linear,    // between the two stops around a height
  discrete,  // the first stop that is not below it
  exact,     // the stop of exactly that height
  nearest,   // the nearest stop
};

struct ColorStop {
  double height_m;
  glm::vec3 color;  // linear Rec. 709
};

struct ColorRamp {
  std::vector<ColorStop> stops;  // by rising height
  RampInterpolation interpolation = RampInterpolation::linear;
  glm::vec3 fallback{0, 0, 0};  // where `exact` or `discrete` names no colour

  // Below the first stop and above the last, linear keeps their colours.
  [[nodiscard]] glm::vec3 at(double height_m) const;
};

// sRGB 0-255 to linear Rec. 709, and a linear component to sRGB 0-1.
[[nodiscard]] glm::vec3 from_srgb8(float red, float green, float blue);
[[nodiscard]] float to_srgb(float linear);
// The nearest of 0 to 255 to 255 * to_srgb(linear).
[[nodiscard]] std::uint8_t to_srgb8(float linear);
// Those of the components of each colour, in turn.
[[nodiscard]] std::vector<std::uint8_t> to_srgb8(std::span<const glm::vec3> linear);
// to_srgb() to within 4e-6, without a power.
[[nodiscard]] float nearly_srgb(float linear);

// Hypsometric tints by absolute altitude, from lowland green to snow.
[[nodiscard]] const ColorRamp& altitude_tints();

}  // namespace terrview

#include "render/color_ramp.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <glm/common.hpp>

namespace terrview {
namespace {

// Of to_srgb(), near black.
constexpr float kLineSlope = 12.92F;
constexpr float kLineEnd = 0.0031308F;

float to_linear(float srgb) {
  return srgb <= 0.04045F ? srgb / kLineSlope : std::pow((srgb + 0.055F) / 1.055F, 2.4F);
}

// By the upper half of a float's bits, the level at its lowest value; and the least value of every
// level. Powers take ten times as long as looking up.
class Levels {
 public:
  Levels() {
    std::uint32_t bits = 0;
    for (std::size_t level = 1; level < 256; ++level) {
      bits = least_bits(static_cast<long>(level), bits);
      least_[level] = std::bit_cast<float>(bits);
      std::fill(lowest_.begin() + (bits + kLowBits) / (kLowBits + 1), lowest_.end(),
                static_cast<std::uint8_t>(level));
    }
    least_.back() = std::numeric_limits<float>::infinity();
  }

  [[nodiscard]] std::uint8_t at(float linear) const {
    // Also where it is not a number.
    const float x = linear > 0 ? std::min(linear, 1.0F) : 0.0F;
    const std::uint32_t level = lowest_[std::bit_cast<std::uint32_t>(x) >> 16];
    // Floats of the same upper half lie less than a level apart.
    return static_cast<std::uint8_t>(level + (x >= least_[level + 1] ? 1 : 0));
  }

 private:
  static constexpr std::uint32_t kLowBits = 0xffff;
  static constexpr auto kOne = std::bit_cast<std::uint32_t>(1.0F);

  // The bits of the least float of a level; those of positive floats are in their order.
  static std::uint32_t least_bits(long level, std::uint32_t from) {
    std::uint32_t to = kOne;
    while (from < to) {
      const std::uint32_t middle = from + (to - from) / 2;
      if (std::lround(to_srgb(std::bit_cast<float>(middle)) * 255) >= level)
        to = middle;
      else
        from = middle + 1;
    }
    return to;
  }

  std::array<float, 257> least_{};
  std::array<std::uint8_t, (kOne >> 16) + 1> lowest_{};
};

const Levels& levels() {
  static const Levels all;
  return all;
}

// By the upper half of a float's bits, a line that follows to_srgb().
class Chords {
 public:
  Chords() {
    for (std::uint32_t i = 0; i + 1 < chords_.size(); ++i) {
      const float from = value_of(i);
      const float to = value_of(i + 1);
      // Where to_srgb() is a line differences may be too small for a quotient.
      const bool is_line = to < kLineEnd;
      chords_[i] = {to_srgb(from),
                    is_line ? kLineSlope : (to_srgb(to) - to_srgb(from)) / (to - from)};
    }
    chords_.back() = {1, 0};
  }

  [[nodiscard]] float at(float linear) const {
    const float x = linear > 0 ? std::min(linear, 1.0F) : 0.0F;
    const std::uint32_t i = std::bit_cast<std::uint32_t>(x) >> 16;
    return chords_[i].start + (x - value_of(i)) * chords_[i].slope;
  }

 private:
  struct Chord {
    float start, slope;
  };
  static float value_of(std::uint32_t i) { return std::bit_cast<float>(i << 16); }

  std::array<Chord, (std::bit_cast<std::uint32_t>(1.0F) >> 16) + 1> chords_{};
};

}  // namespace

glm::vec3 from_srgb8(float red, float green, float blue) {
  return {to_linear(red / 255), to_linear(green / 255), to_linear(blue / 255)};
}

float to_srgb(float linear) {
  const float x = std::clamp(linear, 0.0F, 1.0F);
  return x <= kLineEnd ? kLineSlope * x : 1.055F * std::pow(x, 1 / 2.4F) - 0.055F;
}

std::uint8_t to_srgb8(float linear) { return levels().at(linear); }

std::vector<std::uint8_t> to_srgb8(std::span<const glm::vec3> linear) {
  const Levels& all = levels();
  std::vector<std::uint8_t> bytes(3 * linear.size());
  std::uint8_t* byte = bytes.data();
  for (const glm::vec3& color : linear)
    for (const float component : {color.r, color.g, color.b}) *byte++ = all.at(component);
  return bytes;
}

float nearly_srgb(float linear) {
  static const Chords chords;
  return chords.at(linear);
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

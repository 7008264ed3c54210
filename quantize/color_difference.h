// How far apart two colours look.
//
// CIEDE2000: CIE 142-2001, in the notation of Sharma, Wu & Dalal, "The CIEDE2000 color-difference
// formula: implementation notes, supplementary test data, and mathematical observations", Color
// Research & Application 30 (2005); agrees with their 34 test pairs to their four decimals. About 1
// is the least difference that is seen side by side. CIELAB is that of the D65 white, without
// adaptation. OKLab: B. Ottosson, "A perceptual color space for image processing" (2020); its
// differences are Euclidean.
#pragma once

#include <glm/vec3.hpp>

#include "quantize/color.h"

namespace terrview {

// 0-1, of an 8-bit sRGB component.
[[nodiscard]] double linear_light(std::uint8_t component);

// {L*, a*, b*}, L* from 0 to 100.
[[nodiscard]] glm::dvec3 cielab(Rgb8 color);

// {L, a, b}, L from 0 to 1.
[[nodiscard]] glm::dvec3 oklab(Rgb8 color);

// Of two CIELAB colours, with kL = kC = kH = 1.
[[nodiscard]] double ciede2000(const glm::dvec3& a, const glm::dvec3& b);
[[nodiscard]] double ciede2000(Rgb8 a, Rgb8 b);

// The thesis's: the largest of the components' differences.
[[nodiscard]] int component_difference(Rgb8 a, Rgb8 b);

}  // namespace terrview

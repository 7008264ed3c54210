#include "quantize/color_difference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace terrview {
namespace {

constexpr double kDegree_rad = std::numbers::pi / 180;

double radians(double degrees) { return degrees * kDegree_rad; }

double pow7(double x) { return x * x * x * x * x * x * x; }

std::array<double, 256> linear_lights() {
  std::array<double, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    const double value = static_cast<double>(i) / 255;
    table[i] = value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
  }
  return table;
}

// CIE's cube root with its straight foot.
double lab_curve(double t) {
  constexpr double kFoot = 216.0 / 24389;
  return t > kFoot ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116;
}

// The hue angle in degrees, 0 to 360; 0 for a grey.
double hue_deg(double a, double b) {
  if (a == 0 && b == 0) return 0;
  const double angle = std::atan2(b, a) / kDegree_rad;
  return angle < 0 ? angle + 360 : angle;
}

// Chroma and hue with a* stretched for greys, as the formula wants them.
struct LightChromaHue {
  double light;
  double chroma;
  double hue_deg;
};

LightChromaHue stretch(const glm::dvec3& lab, double stretch_a) {
  const double a = lab.y * stretch_a;
  return {lab.x, std::hypot(a, lab.z), hue_deg(a, lab.z)};
}

double hue_step_deg(const LightChromaHue& a, const LightChromaHue& b) {
  if (a.chroma * b.chroma == 0) return 0;
  const double step = b.hue_deg - a.hue_deg;
  if (step > 180) return step - 360;
  return step < -180 ? step + 360 : step;
}

double mean_hue_deg(const LightChromaHue& a, const LightChromaHue& b) {
  const double sum = a.hue_deg + b.hue_deg;
  if (a.chroma * b.chroma == 0) return sum;
  if (std::abs(a.hue_deg - b.hue_deg) <= 180) return sum / 2;
  return sum < 360 ? (sum + 360) / 2 : (sum - 360) / 2;
}

}  // namespace

double linear_light(std::uint8_t component) {
  static const std::array<double, 256> kTable = linear_lights();
  return kTable[component];
}

glm::dvec3 cielab(Rgb8 color) {
  const double r = linear_light(color.r);
  const double g = linear_light(color.g);
  const double b = linear_light(color.b);
  // IEC 61966-2-1; the white is the sum of each row.
  const double x = (0.4124 * r + 0.3576 * g + 0.1805 * b) / (0.4124 + 0.3576 + 0.1805);
  const double y = (0.2126 * r + 0.7152 * g + 0.0722 * b) / (0.2126 + 0.7152 + 0.0722);
  const double z = (0.0193 * r + 0.1192 * g + 0.9505 * b) / (0.0193 + 0.1192 + 0.9505);
  const double fx = lab_curve(x);
  const double fy = lab_curve(y);
  const double fz = lab_curve(z);
  return {116 * fy - 16, 500 * (fx - fy), 200 * (fy - fz)};
}

glm::dvec3 oklab(Rgb8 color) {
  const double r = linear_light(color.r);
  const double g = linear_light(color.g);
  const double b = linear_light(color.b);
  const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
          1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
          0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

double ciede2000(const glm::dvec3& lab_a, const glm::dvec3& lab_b) {
  const double chroma7 = pow7((std::hypot(lab_a.y, lab_a.z) + std::hypot(lab_b.y, lab_b.z)) / 2);
  const double stretch_a = 1 + 0.5 * (1 - std::sqrt(chroma7 / (chroma7 + pow7(25))));
  const LightChromaHue a = stretch(lab_a, stretch_a);
  const LightChromaHue b = stretch(lab_b, stretch_a);

  const double light = (a.light + b.light) / 2 - 50;
  const double chroma = (a.chroma + b.chroma) / 2;
  const double hue = mean_hue_deg(a, b);
  const double t = 1 - 0.17 * std::cos(radians(hue - 30)) + 0.24 * std::cos(radians(2 * hue)) +
                   0.32 * std::cos(radians(3 * hue + 6)) - 0.20 * std::cos(radians(4 * hue - 63));
  const double scale_l = 1 + 0.015 * light * light / std::sqrt(20 + light * light);
  const double scale_c = 1 + 0.045 * chroma;
  const double scale_h = 1 + 0.015 * chroma * t;
  const double turn_deg = 30 * std::exp(-std::pow((hue - 275) / 25, 2));
  const double turn =
      -2 * std::sqrt(pow7(chroma) / (pow7(chroma) + pow7(25))) * std::sin(radians(2 * turn_deg));

  const double dl = (b.light - a.light) / scale_l;
  const double dc = (b.chroma - a.chroma) / scale_c;
  const double dh =
      2 * std::sqrt(a.chroma * b.chroma) * std::sin(radians(hue_step_deg(a, b) / 2)) / scale_h;
  // Rounding may bring the sum of equal colours below zero.
  return std::sqrt(std::max(0.0, dl * dl + dc * dc + dh * dh + turn * dc * dh));
}

double ciede2000(Rgb8 a, Rgb8 b) { return ciede2000(cielab(a), cielab(b)); }

int component_difference(Rgb8 a, Rgb8 b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

}  // namespace terrview

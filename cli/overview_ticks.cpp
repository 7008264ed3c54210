#include "cli/overview_ticks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include <glm/common.hpp>

namespace terrview {
namespace {

constexpr double kRounding = 1e-9;  // of a step

double smallest_step(double range, int most) {
  double step = std::pow(10.0, std::floor(std::log10(range / most)));
  for (const double times : {1.0, 2.0, 5.0, 10.0})
    if (range <= times * step * most * (1 + kRounding)) return times * step;
  return 10 * step;
}

}  // namespace

Ticks ticks_along(glm::dvec2 from_uv, glm::dvec2 to_uv, const Coordinates& coordinates, int most) {
  const glm::dvec2 first = coordinates(from_uv);
  const glm::dvec2 last = coordinates(to_uv);
  Ticks found;
  found.axis = std::abs(last.x - first.x) >= std::abs(last.y - first.y) ? 0 : 1;
  const double from = first[found.axis];
  const double to = last[found.axis];
  if (!std::isfinite(from) || !std::isfinite(to) || from == to) return found;
  found.step = smallest_step(std::abs(to - from), most);
  const double begin = std::ceil(std::min(from, to) / found.step - kRounding);
  const double end = std::floor(std::max(from, to) / found.step + kRounding);
  constexpr int kHalvings = 60;
  for (double n = begin; n <= end; ++n) {
    const double value = n * found.step;
    double low = 0;
    double high = 1;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = (low + high) / 2;
      const double here = coordinates(glm::mix(from_uv, to_uv, middle))[found.axis];
      ((here < value) == (from < to) ? low : high) = middle;
    }
    found.ticks.push_back({glm::mix(from_uv, to_uv, high), value});
  }
  return found;
}

double round_length(double length) {
  const double power = std::pow(10.0, std::floor(std::log10(length) + kRounding));
  for (const double times : {5.0, 2.0})
    if (times * power <= length * (1 + kRounding)) return times * power;
  return power;
}

std::string coordinate_text(CoordinateKind kind, int axis, double value, double step) {
  const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step) - kRounding)), 0, 9);
  const double half = 0.5 * std::pow(10.0, -decimals);
  const bool signless = kind == CoordinateKind::degrees;
  if (signless && std::abs(value) > 180 + half) value = std::remainder(value, 360.0);
  if (std::abs(value) < half) value = 0;
  std::array<char, 64> number{};
  std::snprintf(number.data(), number.size(), "%.*f", decimals, signless ? std::abs(value) : value);
  if (kind == CoordinateKind::plain) return (axis == 0 ? "x " : "y ") + std::string(number.data());
  const char* side = axis == 0 ? "E" : "N";
  if (signless && value < 0) side = axis == 0 ? "W" : "S";
  return number.data() + std::string(signless ? "° " : " ") + side;
}

}  // namespace terrview

#include <array>
#include <cmath>
#include <complex>
#include <cstdio>
#include <numbers>

#include "bench/sky/field_bench.h"
#include "sky/field_part.h"

namespace terrview {
namespace {

constexpr int kLevels = 6;            // root cells of 64 vertices
constexpr std::int64_t kSide = 2048;  // vertices
constexpr double kLength = 724;       // of a line, in edges

struct Step {
  std::int64_t x;
  std::int64_t y;
};

// The mean power at a wavelength, in edges, of lines through the field along `step`, tapered by
// Hann's window; per unit of length, so that it is the same along any line of an isotropic field.
double power(const std::vector<float>& values, const Step& step, double wavelength) {
  const double spacing = std::hypot(step.x, step.y);
  const auto count = static_cast<std::int64_t>(kLength / spacing);
  double sum = 0;
  int lines = 0;
  for (std::int64_t y = 5; y + step.y * count < kSide; y += 29) {
    for (std::int64_t x = 3; x + step.x * count < kSide; x += 211, ++lines) {
      std::complex<double> amplitude = 0;
      for (std::int64_t i = 0; i < count; ++i) {
        const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
        const double taper = 1 - std::cos(2 * std::numbers::pi * share);
        const double phase = 2 * std::numbers::pi * spacing * static_cast<double>(i) / wavelength;
        const auto at = static_cast<std::size_t>((y + step.y * i) * kSide + x + step.x * i);
        amplitude += taper * static_cast<double>(values[at]) * std::polar(1.0, phase);
      }
      sum += std::norm(amplitude) * spacing * spacing;
    }
  }
  return sum / lines;
}

struct Named {
  const char* name;
  FieldKind kind;
};

}  // namespace

void print_spectrum() {
  std::printf(
      "\nPower along diagonals over that along axes (1: isotropic), h = 0.5, root cells of 64\n"
      "wavelength      48      24      12       6\n");
  for (const Named& field :
       {Named{"midpoint", FieldKind::midpoint}, Named{"displaced", FieldKind::displaced},
        Named{"smooth", FieldKind::smooth}}) {
    FieldOptions options;
    options.kind = field.kind;
    options.levels = {kLevels, kLevels};
    const std::vector<float> values = field_part(RandomField(options), {0, 0, kSide, kSide});
    std::printf("%-10s", field.name);
    for (const double wavelength : {48.0, 24.0, 12.0, 6.0}) {
      const double axes =
          (power(values, {1, 0}, wavelength) + power(values, {0, 1}, wavelength)) / 2;
      std::printf("  %6.2f", power(values, {1, 1}, wavelength) / axes);
    }
    std::printf("\n");
  }
}

}  // namespace terrview

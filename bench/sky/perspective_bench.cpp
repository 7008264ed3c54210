#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "bench/sky/field_bench.h"
#include "sky/cloud_painter.h"

namespace terrview {
namespace {

constexpr glm::ivec2 kSize_px{1920, 1080};
constexpr int kBruteStep_px = 8;  // single pixels are taken on a lattice, and their cost scaled
constexpr double kWholeLeaf_px = 0.01;

SkyCamera camera_of(double pitch_rad) {
  SkyCamera camera;
  camera.size_px = kSize_px;
  camera.middle_px = glm::dvec2(kSize_px) / 2.0;
  camera.focal_px = kSize_px.x / 2.0 / std::tan(std::numbers::pi / 6);
  camera.forward = {0, std::cos(pitch_rad), std::sin(pitch_rad)};
  camera.up = {0, -std::sin(pitch_rad), std::cos(pitch_rad)};
  return camera;
}

double paint_seconds(const CloudPainter& painter) {
  constexpr int kSide_px = CloudPainter::kWindow_px;
  return seconds_of([&] {
    for (int y = 0; y < kSize_px.y; y += kSide_px) {
      for (int x = 0; x < kSize_px.x; x += kSide_px) {
        PixelWindow window{
            {x, y}, {std::min(kSide_px, kSize_px.x - x), std::min(kSide_px, kSize_px.y - y)}, {}};
        window.wanted.assign(static_cast<std::size_t>(window.size_px.x * window.size_px.y), true);
        static_cast<void>(painter.paint(window));
      }
    }
  });
}

struct Brute {
  double seconds_per_pixel;
  std::vector<float> values;
};

Brute single_pixels(const CloudPainter& painter) {
  Brute brute{};
  std::vector<float> values;
  const double seconds = seconds_of([&] {
    values.clear();
    for (int y = 0; y < kSize_px.y; y += kBruteStep_px)
      for (int x = 0; x < kSize_px.x; x += kBruteStep_px)
        values.push_back(painter.value({x, y}).value);
  });
  return {seconds / static_cast<double>(values.size()), values};
}

// Root mean square of what differs, over pixels that see the layer in both.
double error(const std::vector<float>& a, const std::vector<float>& b) {
  double sum = 0;
  double count = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (std::isnan(a[k]) || std::isnan(b[k])) continue;
    sum += std::pow(static_cast<double>(a[k]) - static_cast<double>(b[k]), 2);
    ++count;
  }
  return std::sqrt(sum / count);
}

}  // namespace

void print_perspective() {
  FieldOptions options;
  options.kind = FieldKind::smooth;
  options.levels = {12, 12};
  options.h = {0.6};
  const RandomField field(options);
  CloudLayer layer;
  layer.curvature_per_m = 0.87 / 6.371e6;
  std::printf(
      "\nClouds at 1920 x 1080, one thread: ns/pixel painted and pixel by pixel, and the error\n"
      "against the field divided to its last level, in standard deviations\n"
      "pitch  leaf px  painted  single  error\n");
  const double pixels = static_cast<double>(kSize_px.x) * kSize_px.y;
  for (const double pitch_deg : {15.0, 60.0}) {
    const SkyCamera camera = camera_of(pitch_deg * std::numbers::pi / 180);
    const Brute whole = single_pixels(CloudPainter(field, layer, camera, kWholeLeaf_px));
    for (const double leaf_px : {0.5, 1.0, 2.0, 4.0, 8.0}) {
      const CloudPainter painter(field, layer, camera, leaf_px);
      const Brute brute = single_pixels(painter);
      std::printf("%5.0f  %7.1f  %7.1f  %6.1f  %.4f\n", pitch_deg, leaf_px,
                  1e9 * paint_seconds(painter) / pixels, 1e9 * brute.seconds_per_pixel,
                  error(brute.values, whole.values) / field.expected_deviation());
    }
    std::printf("%5.0f    whole        -  %6.1f  0\n", pitch_deg, 1e9 * whole.seconds_per_pixel);
  }
}

}  // namespace terrview

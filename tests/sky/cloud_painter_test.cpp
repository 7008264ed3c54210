// Promises of sky/cloud_painter.h, sky/image_cell.h, sky/field_cell.h, sky/cloud_layer.h and
// sky/sky_camera.h.
#include "sky/cloud_painter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

#include <glm/geometric.hpp>

#include "sky/field_cell.h"
#include "sky/field_part.h"
#include "sky/image_cell.h"

namespace terrview {
namespace {

constexpr double kRadians = std::numbers::pi / 180;
constexpr double kEarth_per_m = 0.87 / 6.371e6;

struct Aim {
  double heading_deg = 0;
  double pitch_deg = 20;
  double roll_deg = 0;
  double fov_deg = 60;
  bool cylindrical = false;
};

SkyCamera camera_of(const Aim& aim, glm::ivec2 size_px = {150, 100}) {
  const double heading = aim.heading_deg * kRadians;
  const double pitch = aim.pitch_deg * kRadians;
  const double roll = aim.roll_deg * kRadians;
  SkyCamera camera;
  camera.size_px = size_px;
  camera.middle_px = glm::dvec2(size_px) / 2.0;
  camera.cylindrical = aim.cylindrical;
  camera.focal_px = aim.cylindrical ? size_px.x / (aim.fov_deg * kRadians)
                                    : size_px.x / 2.0 / std::tan(aim.fov_deg * kRadians / 2);
  camera.forward = {std::sin(heading) * std::cos(pitch), std::cos(heading) * std::cos(pitch),
                    std::sin(pitch)};
  const glm::dvec3 level(std::cos(heading), -std::sin(heading), 0);
  const glm::dvec3 upright = glm::cross(level, camera.forward);
  camera.right = level * std::cos(roll) - upright * std::sin(roll);
  camera.up = upright * std::cos(roll) + level * std::sin(roll);
  return camera;
}

RandomField field_of(FieldKind kind, int levels = 9) {
  FieldOptions options;
  options.kind = kind;
  options.seed = 3;
  options.levels = {levels, levels};
  options.h = {0.6};
  return RandomField(options);
}

CloudLayer layer_of(double curvature_per_m) {
  CloudLayer layer;
  layer.height_m = 2000;
  layer.curvature_per_m = curvature_per_m;
  layer.origin_m = {-12345, 6789};
  return layer;
}

// The whole picture by windows of a side, in columns of windows or in rows of them.
std::vector<CloudSample> painted(const CloudPainter& painter, glm::ivec2 size, int window_height) {
  std::vector<CloudSample> all(static_cast<std::size_t>(size.x * size.y));
  for (int y = 0; y < size.y; y += window_height) {
    for (int x = 0; x < size.x; x += CloudPainter::kWindow_px) {
      PixelWindow window;
      window.first_px = {x, y};
      window.size_px = {std::min(CloudPainter::kWindow_px, size.x - x),
                        std::min(window_height, size.y - y)};
      window.wanted.assign(static_cast<std::size_t>(window.size_px.x * window.size_px.y), true);
      const auto samples = painter.paint(window);
      for (int row = 0; row < window.size_px.y; ++row)
        for (int column = 0; column < window.size_px.x; ++column)
          all[static_cast<std::size_t>((y + row) * size.x + x + column)] =
              samples[static_cast<std::size_t>(row * window.size_px.x + column)];
    }
  }
  return all;
}

bool same_bits(float a, float b) {
  return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

const std::vector<Aim> kAims{{},
                             {30, 5, 0, 60, false},
                             {200, 60, 25, 90, false},
                             {90, -10, 0, 50, false},
                             {0, 90, 0, 100, false},
                             {310, 10, 90, 40, false},
                             {0, 0, 0, 360, true},
                             {77, 0, 0, 100, true}};

TEST(CloudPainter, AgreesBitForBitWithSinglePixels) {
  for (const FieldKind kind : {FieldKind::midpoint, FieldKind::displaced, FieldKind::smooth}) {
    const RandomField field = field_of(kind);
    for (const double curvature : {0.0, kEarth_per_m}) {
      for (const Aim& aim : kAims) {
        const SkyCamera camera = camera_of(aim);
        const CloudPainter painter(field, layer_of(curvature), camera);
        const auto all = painted(painter, camera.size_px, 64);
        int seen = 0;
        for (int row = 0; row < camera.size_px.y; row += 3) {
          for (int column = 0; column < camera.size_px.x; column += 2) {
            const CloudSample one = painter.value({column, row});
            const auto& other = all[static_cast<std::size_t>(row * camera.size_px.x + column)];
            ASSERT_TRUE(same_bits(one.value, other.value))
                << column << ' ' << row << ' ' << aim.heading_deg << ' ' << curvature;
            ASSERT_EQ(one.distance_m, other.distance_m);
            seen += std::isnan(one.value) ? 0 : 1;
          }
        }
        EXPECT_GT(seen, 200);
      }
    }
  }
}

TEST(CloudPainter, GivesTheSameBytesForAnyWindows) {
  const RandomField field = field_of(FieldKind::smooth);
  for (const Aim& aim : {kAims[2], kAims[6]}) {
    const SkyCamera camera = camera_of(aim);
    const CloudPainter painter(field, layer_of(kEarth_per_m), camera);
    const auto all = painted(painter, camera.size_px, 64);
    const auto other = painted(painter, camera.size_px, 7);
    for (std::size_t k = 0; k < all.size(); ++k)
      ASSERT_TRUE(same_bits(all[k].value, other[k].value)) << k;
  }
}

TEST(CloudPainter, PaintsWhatIsWantedOnly) {
  const RandomField field = field_of(FieldKind::midpoint);
  const SkyCamera camera = camera_of({});
  const CloudPainter painter(field, layer_of(0), camera);
  PixelWindow window{{0, 0}, {20, 20}, std::vector<bool>(400, false)};
  window.wanted[57] = true;
  const auto samples = painter.paint(window);
  for (std::size_t k = 0; k < samples.size(); ++k)
    EXPECT_EQ(std::isnan(samples[k].value), k != 57) << k;
}

// The field divided to its last level, at the place where a line meets the layer: of paint()'s code
// nothing but the draws.
float deepest(const RandomField& field, const glm::dvec2& place) {
  const int levels = field.levels();
  const glm::dvec2 fine(std::ldexp(place.x, levels), std::ldexp(place.y, levels));
  const glm::dvec2 low = glm::floor(fine);
  const auto v =
      field_part(field, {static_cast<std::int64_t>(low.x), static_cast<std::int64_t>(low.y), 2, 2});
  const auto s = static_cast<float>(fine.x - low.x);
  const auto t = static_cast<float>(fine.y - low.y);
  return (1 - t) * ((1 - s) * v[0] + s * v[1]) + t * ((1 - s) * v[2] + s * v[3]);
}

double root_mean_square_error(double leaf_px) {
  const RandomField field = field_of(FieldKind::smooth, 12);
  const CloudLayer layer = layer_of(kEarth_per_m);
  const SkyCamera camera = camera_of({.pitch_deg = 40});
  const CloudPainter painter(field, layer, camera, leaf_px);
  double sum = 0;
  double count = 0;
  for (int row = 0; row < 100; row += 5) {
    for (int column = 0; column < 150; column += 5, ++count) {
      const glm::dvec3 direction = camera.direction({column + 0.5, row + 0.5});
      // A bisection along the line instead of the layer's formula.
      double low = 0;
      double high = 1e6;
      for (int step = 0; step < 200; ++step) {
        const double t = (low + high) / 2;
        const double s2 = t * t * (direction.x * direction.x + direction.y * direction.y);
        (t * direction.z < layer.height_m - s2 * layer.curvature_per_m / 2 ? low : high) = t;
      }
      const glm::dvec2 place = (glm::dvec2(direction) * low + layer.origin_m) / layer.cell_m;
      const double error = static_cast<double>(painter.value({column, row}).value) -
                           static_cast<double>(deepest(field, place));
      sum += error * error;
    }
  }
  return std::sqrt(sum / count) / field.expected_deviation();
}

TEST(CloudPainter, ComesNearerTheWholeFieldTheSmallerItsLeaves) {
  const double coarse = root_mean_square_error(8);
  const double pixel = root_mean_square_error(1);
  const double tiny = root_mean_square_error(0.01);
  EXPECT_LT(coarse, 0.4);
  EXPECT_LT(pixel, 0.11);
  EXPECT_LT(pixel, coarse / 2);
  EXPECT_LT(tiny, 1e-5);
}

TEST(FieldCell, HasTheValuesOfThePart) {
  const auto check = [](auto kind) {
    using Cell = FieldCell<decltype(kind)::value>;
    const RandomField field = field_of(decltype(kind)::value, 6);
    CellPlace at{0, -3, 2};
    Cell cell = Cell::root(field, at);
    for (const int k : {3, 0, 2, 1, 1, 2}) {
      cell = cell.divided(field, at)[static_cast<std::size_t>(k)];
      at = at.child(k);
    }
    const auto part = field_part(field, {at.column, at.row, 2, 2});
    for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(cell.corners()[k], part[k]) << k;
  };
  check(std::integral_constant<FieldKind, FieldKind::midpoint>{});
  check(std::integral_constant<FieldKind, FieldKind::displaced>{});
  check(std::integral_constant<FieldKind, FieldKind::smooth>{});
}

TEST(HarmonicMiddle, DividesHarmonicallyWithThePointAtInfinity) {
  CloudLayer layer = layer_of(0);
  const LayerImage image(layer, camera_of({200, 60, 25, 90, false}));
  const SkyCamera camera = camera_of({200, 60, 25, 90, false});
  const glm::dvec2 a(-1.2, 0.7);
  for (const glm::dvec2 b : {glm::dvec2(-1.7, 0.7), glm::dvec2(-1.2, 0.3), glm::dvec2(-1.5, 0.2)}) {
    const auto px = [](const ImagePoint& p) { return glm::dvec2(p.x, p.y) / p.w; };
    const glm::dvec2 u = px(image.at(a));
    const glm::dvec2 v = px(image.at(b));
    const glm::dvec2 m = px(harmonic_middle(image.at(a), image.at(b)));
    const glm::dvec3 direction(glm::normalize(b - a), 0);
    const double depth = glm::dot(direction, camera.forward);
    const glm::dvec2 infinity =
        glm::dvec2(camera.size_px) / 2.0 +
        camera.focal_px / depth *
            glm::dvec2(glm::dot(direction, camera.right), -glm::dot(direction, camera.up));
    // Ratios of signed lengths along the line.
    const glm::dvec2 along = glm::normalize(v - u);
    const auto ratio = [&](const glm::dvec2& from) {
      return glm::dot(u - from, along) / glm::dot(v - from, along);
    };
    EXPECT_NEAR(ratio(infinity), -ratio(m), 1e-9 * std::abs(ratio(m)));
    EXPECT_LT(glm::distance(m, px(image.at((a + b) / 2.0))), 1e-9);
  }
}

TEST(CloudLayer, MeetsLinesOnItself) {
  for (const double curvature : {0.0, kEarth_per_m}) {
    const CloudLayer layer = layer_of(curvature);
    for (const double elevation : {-1.0, -0.3, 0.0, 0.5, 5.0, 45.0, 90.0}) {
      const glm::dvec3 direction =
          7.0 * glm::dvec3(std::cos(elevation * kRadians), 0, std::sin(elevation * kRadians));
      const auto t = layer.distance(direction);
      if (!t) continue;
      const glm::dvec3 met = direction * *t;
      const glm::dvec3 point = layer.point_m(layer.field_place(glm::dvec2(met)));
      EXPECT_LT(glm::distance(met, point), 1e-6 * (1 + glm::length(met))) << elevation;
    }
  }
}

TEST(CloudLayer, APlaneEndsAtTheHorizonAndAShellBelowIt) {
  CloudLayer plane = layer_of(0);
  CloudLayer shell = layer_of(kEarth_per_m);
  EXPECT_FALSE(plane.distance({1, 0, 0}));
  EXPECT_FALSE(plane.distance({1, 0, -0.01}));
  EXPECT_TRUE(shell.distance({1, 0, 0}));
  shell.reach_m = 1e5;
  EXPECT_FALSE(shell.distance({1, 0, 0}));
  plane.height_m = -5;
  EXPECT_FALSE(plane.distance({0, 0, 1}));
}

TEST(SkyCamera, FacingShowsTheSameInItsColumn) {
  const SkyCamera panorama = camera_of({40, 0, 0, 360, true});
  for (const double column : {0.5, 40.0, 149.5}) {
    const SkyCamera flat = panorama.facing(column);
    const glm::dvec3 direction = glm::normalize(panorama.direction({column, 20}));
    EXPECT_LT(glm::distance(glm::normalize(flat.direction({column, 20})), direction), 1e-12);
  }
}

TEST(SkyCamera, APanoramaClosesWithoutASeam) {
  const SkyCamera panorama = camera_of({40, 0, 0, 360, true}, {720, 100});
  const RandomField field = field_of(FieldKind::smooth, 7);
  const CloudPainter painter(field, layer_of(kEarth_per_m), panorama);
  double seam = 0;
  double elsewhere = 0;
  for (int row = 0; row < 50; ++row) {
    const auto value = [&](int column) {
      return static_cast<double>(painter.value({column, row}).value);
    };
    seam += std::abs(value(719) - value(0));
    for (int column = 100; column < 110; ++column)
      elsewhere += std::abs(value(column) - value(column + 1)) / 10;
  }
  EXPECT_LT(seam, 2 * elsewhere);
  EXPECT_GT(seam, 0);
}

}  // namespace
}  // namespace terrview

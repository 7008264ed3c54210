// One test per promise of render/camera.h. Expected directions come from rotations of a camera that
// looks north, axis by axis.
#include "render/camera.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>

#include "terrain/error.h"

namespace terrview {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kRadians = kPi / 180;
constexpr glm::dvec3 kEast(1, 0, 0);
constexpr glm::dvec3 kNorth(0, 1, 0);
constexpr glm::dvec3 kUp(0, 0, 1);

// `vector` turned about the unit `axis` by the right-hand rule (Rodrigues).
glm::dvec3 turned(const glm::dvec3& vector, const glm::dvec3& axis, double angle_rad) {
  return vector * std::cos(angle_rad) + glm::cross(axis, vector) * std::sin(angle_rad) +
         axis * (glm::dot(axis, vector) * (1 - std::cos(angle_rad)));
}

// A direction of a camera that looks north, level, as `options` turn it: clockwise as seen from
// behind, then up, then clockwise from north.
glm::dvec3 as_turned(const glm::dvec3& direction, const CameraOptions& options) {
  const glm::dvec3 rolled = turned(direction, kNorth, options.roll_rad);
  const glm::dvec3 pitched = turned(rolled, kEast, options.pitch_rad);
  return turned(pitched, kUp, -options.heading_rad);
}

double angle_rad(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

std::vector<CameraOptions> some_cameras(Projection projection) {
  std::vector<CameraOptions> cameras;
  for (const glm::ivec2 size_px : {glm::ivec2(64, 48), glm::ivec2(33, 51), glm::ivec2(1, 1)}) {
    for (const double heading_deg : {0.0, 73.0, 200.0, 359.5}) {
      CameraOptions options{.projection = projection,
                            .heading_rad = heading_deg * kRadians,
                            .fov_rad = 50 * kRadians,
                            .width_m = 1234,
                            .size_px = size_px};
      cameras.push_back(options);
      if (projection == Projection::cylindrical) continue;
      options.pitch_rad = -35 * kRadians;
      options.roll_rad = 110 * kRadians;
      cameras.push_back(options);
    }
  }
  return cameras;
}

std::vector<glm::dvec2> some_image_points(glm::ivec2 size_px) {
  const glm::dvec2 size(size_px);
  return {{0.5, 0.5}, {size.x - 0.5, 0.5}, {0, size.y}, size / 2.0, {0.3 * size.x, 0.8 * size.y}};
}

TEST(Camera, LooksAlongItsHeadingAndPitch) {
  const Camera camera({.heading_rad = 120 * kRadians, .pitch_rad = 25 * kRadians});
  const glm::dvec3 expected(std::sin(120 * kRadians) * std::cos(25 * kRadians),
                            std::cos(120 * kRadians) * std::cos(25 * kRadians),
                            std::sin(25 * kRadians));
  EXPECT_LT(angle_rad(camera.ray({640, 360}).direction, expected), 1e-15);
}

TEST(Camera, RollsClockwiseAsSeenFromBehind) {
  // Rolled by a quarter turn, the right side of the picture looks down.
  const Camera camera({.roll_rad = kPi / 2, .size_px = {100, 100}});
  EXPECT_LT(camera.ray({99, 50}).direction.z, -0.1);
  EXPECT_GT(camera.ray({50, 1}).direction.x, 0.1);
}

TEST(PerspectiveCamera, HasTheFieldOfViewFromEdgeToEdge) {
  for (const double fov_deg : {1.0, 60.0, 120.0, 179.0}) {
    const Camera camera({.pitch_rad = 0.3, .fov_rad = fov_deg * kRadians, .size_px = {80, 20}});
    EXPECT_NEAR(angle_rad(camera.ray({0, 10}).direction, camera.ray({80, 10}).direction),
                fov_deg * kRadians, 1e-12);
  }
}

TEST(PerspectiveCamera, LooksThroughThePointsOfAPlane) {
  for (const CameraOptions& options : some_cameras(Projection::perspective)) {
    const Camera camera(options);
    const glm::dvec2 size(options.size_px);
    for (const glm::dvec2 point : some_image_points(options.size_px)) {
      const double k = std::tan(options.fov_rad / 2) / (size.x / 2);
      const glm::dvec3 level((point.x - size.x / 2) * k, 1, (size.y / 2 - point.y) * k);
      EXPECT_LT(angle_rad(camera.ray(point).direction, as_turned(level, options)), 1e-14);
      EXPECT_EQ(camera.ray(point).origin_m, glm::dvec3(0));
    }
  }
}

// What a shifted lens shows is part of what a wider one shows.
TEST(PerspectiveCamera, ShiftsThePictureOverItsPlane) {
  const CameraOptions wide{
      .heading_rad = 0.4, .pitch_rad = 0.2, .roll_rad = -0.3, .size_px = {300, 300}};
  CameraOptions shifted = wide;
  shifted.size_px = {100, 60};
  shifted.fov_rad = 2 * std::atan(std::tan(wide.fov_rad / 2) / 3);
  shifted.shift = {0.5, -1.25};
  for (const glm::dvec2 point : some_image_points(shifted.size_px)) {
    const glm::dvec2 in_wide = point + glm::dvec2(100, 120) + glm::dvec2(50, 75);
    const glm::dvec3 direction = Camera(shifted).ray(point).direction;
    EXPECT_LT(angle_rad(direction, Camera(wide).ray(in_wide).direction), 1e-14);
    EXPECT_LT(glm::distance(Camera(shifted).project(direction).value(), point), 1e-9);
  }
}

TEST(PerspectiveCamera, KeepsPlumbLinesUprightUnderAShiftedLens) {
  const Camera camera({.heading_rad = 1, .shift = {0.3, 0.8}, .size_px = {400, 300}});
  for (const double aside_m : {-40.0, 10.0, 90.0}) {
    const glm::dvec3 foot = 100.0 * camera.forward() + aside_m * camera.right();
    const glm::dvec2 low = camera.project(foot).value();
    const glm::dvec2 high = camera.project(foot + 60.0 * kUp).value();
    EXPECT_NEAR(low.x, high.x, 1e-9);
    EXPECT_NEAR(low.y, 150 + 0.8 * 300, 1e-6);
  }
}

TEST(CylindricalCamera, IsLinearInAzimuthAndInTheTangentOfElevation) {
  for (const CameraOptions& options : some_cameras(Projection::cylindrical)) {
    const Camera camera(options);
    const glm::dvec2 size(options.size_px);
    for (const glm::dvec2 point : some_image_points(options.size_px)) {
      const glm::dvec3 direction = camera.ray(point).direction;
      const double azimuth = std::atan2(direction.x, direction.y);
      const double expected =
          options.heading_rad + (point.x - size.x / 2) * options.fov_rad / size.x;
      EXPECT_NEAR(std::remainder(azimuth - expected, 2 * kPi), 0, 1e-14);
      const double focal_px = size.x / options.fov_rad;
      EXPECT_NEAR(direction.z / std::hypot(direction.x, direction.y),
                  (size.y / 2 - point.y) / focal_px, 1e-14);
    }
  }
}

TEST(CylindricalCamera, MayLookAllAround) {
  const Camera camera(
      {.projection = Projection::cylindrical, .fov_rad = 360 * kRadians, .size_px = {360, 90}});
  EXPECT_LT(angle_rad(camera.ray({0, 45}).direction, -kNorth), 1e-14);
  EXPECT_LT(angle_rad(camera.ray({90, 45}).direction, -kEast), 1e-14);
  EXPECT_LT(angle_rad(camera.ray({360, 45}).direction, -kNorth), 1e-14);
}

TEST(OrthographicCamera, HasParallelRaysAcrossItsWidth) {
  for (const CameraOptions& options : some_cameras(Projection::orthographic)) {
    const Camera camera(options);
    const glm::dvec2 size(options.size_px);
    const double metres_per_px = options.width_m / size.x;
    for (const glm::dvec2 point : some_image_points(options.size_px)) {
      const Ray ray = camera.ray(point);
      EXPECT_LT(angle_rad(ray.direction, as_turned(kNorth, options)), 1e-14);
      const glm::dvec3 level((point.x - size.x / 2) * metres_per_px, 0,
                             (size.y / 2 - point.y) * metres_per_px);
      EXPECT_LT(glm::distance(ray.origin_m, as_turned(level, options)), 1e-10);
    }
  }
}

class EveryProjection : public testing::TestWithParam<Projection> {};

TEST_P(EveryProjection, ProjectsThePointsOfARayOntoItsPixel) {
  for (const CameraOptions& options : some_cameras(GetParam())) {
    const Camera camera(options);
    for (const glm::dvec2 point : some_image_points(options.size_px)) {
      const Ray ray = camera.ray(point);
      for (const double distance_m : {0.01, 1.0, 1e5}) {
        const auto image = camera.project(ray.origin_m + distance_m * ray.direction);
        ASSERT_TRUE(image);
        EXPECT_LT(glm::distance(*image, point), 1e-7);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Camera, EveryProjection,
                         testing::Values(Projection::perspective, Projection::cylindrical,
                                         Projection::orthographic));

TEST_P(EveryProjection, AimsARowAsItAimsItsRays) {
  constexpr std::size_t kCount = 37;
  std::array<double, kCount> x{};
  std::array<double, kCount> y{};
  std::array<double, kCount> z{};
  for (const CameraOptions& options : some_cameras(GetParam())) {
    const Camera camera(options);
    for (const glm::dvec2 first_px : {glm::dvec2(0.5, 0.5), glm::dvec2(100.3, 77.9)}) {
      camera.aim_row(first_px, {x, y, z});
      for (std::size_t i = 0; i < kCount; ++i) {
        const glm::dvec2 at_px = first_px + glm::dvec2(static_cast<double>(i), 0);
        EXPECT_EQ(glm::dvec3(x[i], y[i], z[i]), camera.ray(at_px).direction);
      }
    }
  }
}

TEST(PerspectiveCamera, ProjectsNothingFromBehind) {
  const Camera camera({.heading_rad = kPi / 2});
  EXPECT_TRUE(camera.project({10, 3, 2}));
  EXPECT_FALSE(camera.project({-10, 3, 2}));
  EXPECT_FALSE(camera.project({-1e-9, 3, 2}));
}

TEST(Camera, HasUprightColumnsBitForBitWhereItSaysSo) {
  const CameraOptions level{.heading_rad = 2, .size_px = {31, 17}};
  CameraOptions shifted = level;
  shifted.shift = {0.21, -0.7};
  CameraOptions around = level;
  around.projection = Projection::cylindrical;
  for (const CameraOptions& options : {level, shifted, around}) {
    const Camera camera(options);
    for (int column = 0; column < 31; ++column) {
      for (int row = 0; row < 17; ++row) {
        const glm::dvec3 direction = camera.ray({column + 0.5, row + 0.5}).direction;
        EXPECT_EQ(glm::dvec2(direction), glm::dvec2(camera.ray({column + 0.5, 0.5}).direction));
        EXPECT_EQ(direction.z, camera.ray({0.5, row + 0.5}).direction.z);
      }
    }
  }
}

TEST(Camera, RefusesWhatMakesNoPicture) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto expect_refused = [](const CameraOptions& options, const std::string& option) {
    try {
      const Camera camera(options);
      ADD_FAILURE() << "accepted a bad " << option;
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).rfind(option + ":", 0), 0U) << error.what();
    }
  };
  for (const double fov_deg : {-10.0, 0.0, 180.0, 400.0, nan})
    expect_refused({.fov_rad = fov_deg * kRadians}, "--fov");
  for (const double fov_deg : {-10.0, 0.0, 360.1, nan})
    expect_refused({.projection = Projection::cylindrical, .fov_rad = fov_deg * kRadians}, "--fov");
  for (const glm::ivec2 size_px :
       {glm::ivec2(0, 10), glm::ivec2(10, 0), glm::ivec2(-3, 10), glm::ivec2((1 << 20) + 1, 1)})
    expect_refused({.size_px = size_px}, "--size");
  for (const double width_m : {-10.0, 0.0, nan})
    expect_refused({.projection = Projection::orthographic, .width_m = width_m}, "--width");
  expect_refused({.projection = Projection::cylindrical, .pitch_rad = 0.1}, "--pitch, --roll");
  expect_refused({.projection = Projection::cylindrical, .roll_rad = 0.1}, "--pitch, --roll");
  expect_refused({.shift = {nan, 0}}, "--shift");
  expect_refused({.shift = {0, 17}}, "--shift");
  expect_refused({.projection = Projection::cylindrical, .shift = {0.1, 0}}, "--shift");
  expect_refused({.projection = Projection::orthographic, .width_m = 9, .shift = {0, 0.1}},
                 "--shift");
}

TEST(OrthographicCamera, NeedsNoFieldOfView) {
  EXPECT_NO_THROW(Camera({.projection = Projection::orthographic, .fov_rad = 0, .width_m = 5}));
}

}  // namespace
}  // namespace terrview

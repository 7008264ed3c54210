// The regions of Coquillart 1984, chapter 2, 4.3, and what makes them right.
#include "render/neighbour_order.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "tests/render/hills.h"

namespace terrview {
namespace {

Camera camera_of(double pitch_deg, double roll_deg, glm::ivec2 size_px = {41, 31}) {
  return Camera({.heading_rad = 0.3,
                 .pitch_rad = pitch_deg * kRadians,
                 .roll_rad = roll_deg * kRadians,
                 .size_px = size_px});
}

void expect_forerunners(const NeighbourOrder& order, glm::ivec2 pixel, glm::ivec2 straight,
                        glm::ivec2 diagonal) {
  const Forerunners found = order.forerunners(pixel);
  ASSERT_EQ(found.count, 2) << pixel.x << ' ' << pixel.y;
  EXPECT_EQ(found.first, pixel + straight) << pixel.x << ' ' << pixel.y;
  EXPECT_EQ(found.second, pixel + diagonal) << pixel.x << ' ' << pixel.y;
}

// A pixel of each region, about OE in the middle: x and y upwards as the thesis has them.
struct Seen {
  glm::ivec2 from_oe;
  glm::ivec2 straight;
  glm::ivec2 diagonal;
};
const std::vector<Seen> kDescending{{{9, 4}, {-1, 0}, {-1, -1}}, {{4, 9}, {0, -1}, {-1, -1}},
                                    {{-4, 9}, {0, -1}, {1, -1}}, {{-9, 4}, {1, 0}, {1, -1}},
                                    {{-9, -4}, {1, 0}, {1, 1}},  {{-4, -9}, {0, 1}, {1, 1}},
                                    {{4, -9}, {0, 1}, {-1, 1}},  {{9, -4}, {-1, 0}, {-1, 1}}};

glm::ivec2 downwards(glm::ivec2 step) { return {step.x, -step.y}; }

TEST(NeighbourOrder, HasEightRegionsAboutTheNadir) {
  const NeighbourOrder order(camera_of(-90, 0));
  for (const Seen& seen : kDescending)
    expect_forerunners(order, glm::ivec2(20, 15) + downwards(seen.from_oe),
                       downwards(seen.straight), downwards(seen.diagonal));
}

TEST(NeighbourOrder, HasThemTheOtherWayRoundAboutTheZenith) {
  const NeighbourOrder order(camera_of(90, 0));
  for (const Seen& seen : kDescending)
    expect_forerunners(order, glm::ivec2(20, 15) + downwards(seen.from_oe),
                       -downwards(seen.straight), -downwards(seen.diagonal));
}

// Rolled clockwise, the camera sees the zenith turn anticlockwise.
TEST(NeighbourOrder, HasEightRangesOfRollInALevelView) {
  const std::vector<std::pair<glm::ivec2, glm::ivec2>> below{
      {{0, 1}, {1, 1}},    {{1, 0}, {1, 1}},    {{1, 0}, {1, -1}},  {{0, -1}, {1, -1}},
      {{0, -1}, {-1, -1}}, {{-1, 0}, {-1, -1}}, {{-1, 0}, {-1, 1}}, {{0, 1}, {-1, 1}}};
  for (int range = 0; range < 8; ++range) {
    const NeighbourOrder order(camera_of(0, 45 * range + 20));
    const auto& [straight, diagonal] = below[static_cast<std::size_t>(range)];
    expect_forerunners(order, {20, 15}, straight, diagonal);
  }
}

TEST(NeighbourOrder, HasOneForerunnerInThePixelsOwnPlane) {
  const NeighbourOrder down(camera_of(-90, 0));
  for (const glm::ivec2 towards : {glm::ivec2(1, 0), {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}}) {
    const Forerunners found = down.forerunners(glm::ivec2(20, 15) + 7 * towards);
    ASSERT_EQ(found.count, 1);
    EXPECT_EQ(found.first, glm::ivec2(20, 15) + 6 * towards);
  }
  EXPECT_EQ(down.forerunners({20, 15}).count, 0);
  const NeighbourOrder level(camera_of(0, 0));
  ASSERT_EQ(level.forerunners({3, 4}).count, 1);
  EXPECT_EQ(level.forerunners({3, 4}).first, glm::ivec2(3, 5));
  EXPECT_EQ(level.forerunners({3, 30}).count, 0);
}

// OE inside the picture, on its edge, outside, far away and at infinity; any roll.
std::vector<Camera> many_cameras() {
  std::vector<Camera> cameras;
  for (const double roll_deg : {0.0, 13.0, 45.0, 90.0, 161.0, 250.0, 315.0})
    for (const double pitch_deg :
         {-90.0, -80.0, -61.0, -35.0, -10.0, -1e-3, -1e-7, 0.0, 1e-3, 4.0, 35.0, 66.0, 90.0})
      cameras.push_back(camera_of(pitch_deg, roll_deg));
  // On the lower edge: half the picture's height below its middle.
  const double half_rad = std::atan(15.5 * camera_of(0, 0).per_px());
  cameras.push_back(camera_of(-90 + half_rad / kRadians, 0));
  cameras.push_back(
      Camera({.projection = Projection::cylindrical, .fov_rad = 2, .size_px = {41, 31}}));
  return cameras;
}

TEST(NeighbourOrder, TracesEveryPixelOnceAfterItsForerunners) {
  for (const Camera& camera : many_cameras()) {
    const NeighbourOrder order(camera);
    Raster<int> step_of(41, 31, -1);
    const auto steps = order.steps();
    for (std::size_t step = 0; step < steps.size(); ++step)
      for (const glm::ivec2& pixel : steps[step]) {
        EXPECT_EQ(step_of.at(pixel.x, pixel.y), -1);
        step_of.at(pixel.x, pixel.y) = static_cast<int>(step);
      }
    for (int row = 0; row < 31; ++row)
      for (int column = 0; column < 41; ++column) {
        const int own = step_of.at(column, row);
        ASSERT_GE(own, 0);
        const Forerunners before = order.forerunners({column, row});
        if (before.count > 0) {
          EXPECT_LT(step_of.at(before.first.x, before.first.y), own);
        }
        if (before.count > 1) {
          EXPECT_LT(step_of.at(before.second.x, before.second.y), own);
        }
      }
  }
}

// Definition 2: the ray lies between the vertical planes of its forerunners and above their plane.
TEST(NeighbourOrder, PutsARayAboveItsForerunners) {
  int seen = 0;
  for (const Camera& camera : many_cameras()) {
    const NeighbourOrder order(camera);
    const auto ray = [&](glm::ivec2 pixel) {
      return camera.ray(glm::dvec2(pixel) + 0.5).direction;
    };
    const auto turn = [](const glm::dvec3& a, const glm::dvec3& b) {
      return a.x * b.y - a.y * b.x;
    };
    for (int row = 0; row < 31; ++row)
      for (int column = 0; column < 41; ++column) {
        const Forerunners before = order.forerunners({column, row});
        if (before.count < 2) continue;
        ++seen;
        const glm::dvec3 own = ray({column, row});
        const glm::dvec3 first = ray(before.first);
        const glm::dvec3 second = ray(before.second);
        EXPECT_GE(turn(first, own) * turn(own, second), -1e-15);
        const glm::dvec3 plane = glm::cross(first, second);
        EXPECT_GE(glm::dot(plane, own) * plane.z, -1e-15)
            << camera.options().pitch_rad << ' ' << camera.options().roll_rad << ' ' << column
            << ' ' << row;
      }
  }
  EXPECT_GT(seen, 50000);
}

}  // namespace
}  // namespace terrview

// One test per promise of terrain/sky_view.h.
#include "terrain/sky_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "tests/support/scenes.h"

namespace terrview {
namespace {

constexpr double kPi = std::numbers::pi;

glm::dmat2 spaced(double x_m, double y_m) { return {1 / x_m, 0, 0, -1 / y_m}; }

SkyView sky_view(const HeightGrid& grid, const glm::dmat2& jacobian, int azimuths,
                 double z_scale = 1) {
  SkyViewSweep sweep(grid, jacobian, z_scale, azimuths);
  for (int step = 0; step < sweep.steps(); ++step) {
    for (int part = sweep.parts(step); part-- > 0;) sweep.sweep(step, part);
  }
  return sweep.result();
}

// The plain twin: from each post, along each azimuth, the steepest of all crossings of the line
// with rows and columns; the light above it in closed form, from the plane of the slope up.
double brute_force(const HeightGrid& grid, const glm::dmat2& jacobian, glm::ivec2 post,
                   int azimuths) {
  const auto height = [&](glm::dvec2 at) {
    const glm::ivec2 cell(std::min(static_cast<int>(at.x), grid.columns - 2),
                          std::min(static_cast<int>(at.y), grid.rows - 2));
    const glm::dvec2 f = at - glm::dvec2(cell);
    return (1 - f.y) * ((1 - f.x) * grid.at(cell.x, cell.y) + f.x * grid.at(cell.x + 1, cell.y)) +
           f.y * ((1 - f.x) * grid.at(cell.x, cell.y + 1) + f.x * grid.at(cell.x + 1, cell.y + 1));
  };
  const glm::dvec2 here(post);
  const double here_m = grid.at(post.x, post.y);
  const glm::dvec2 slope_m((grid.at(post.x + 1, post.y) - grid.at(post.x - 1, post.y)) / 2.0,
                           (grid.at(post.x, post.y + 1) - grid.at(post.x, post.y - 1)) / 2.0);
  const glm::dvec2 gradient = glm::transpose(jacobian) * slope_m;
  const glm::dvec3 normal = glm::normalize(glm::dvec3(-gradient, 1));
  double light = 0;
  for (int i = 0; i < azimuths; ++i) {
    const double azimuth = 2 * kPi * (i + 0.5) / azimuths;
    const glm::dvec2 towards(std::sin(azimuth), std::cos(azimuth));
    const glm::dvec2 posts = jacobian * towards;
    double steepest = 0;
    for (int axis = 0; axis < 2; ++axis) {
      const double a_post_m = 1 / std::abs(posts[axis]);
      if (a_post_m > 1e9) continue;
      for (int crossing = 1;; ++crossing) {
        glm::dvec2 at = here + crossing * a_post_m * posts;
        at[axis] = std::round(at[axis]);
        if (!grid.covers(at)) break;
        steepest = std::max(steepest, (height(at) - here_m) / (crossing * a_post_m));
      }
    }
    const double h = std::atan(steepest);
    const double tilt = glm::dot(glm::dvec2(normal), towards);
    light +=
        normal.z * std::cos(h) * std::cos(h) + tilt * (kPi / 2 - h - std::sin(h) * std::cos(h));
  }
  return light / azimuths;
}

TEST(SkyView, OfAnOpenPlainIsAllOfTheSky) {
  const HeightGrid plain = make_grid(40, 30, [](int, int) { return 250.0; });
  for (const int azimuths : {1, 16, 32, 64}) {
    for (const float share : sky_view(plain, spaced(60, 90), azimuths).shares)
      EXPECT_NEAR(share, 1, 1e-5);
  }
}

TEST(SkyView, OfAnEndlessSlopeIsHalfOfOneAndItsCosine) {
  for (const double rise : {0.3, 1.0}) {
    const HeightGrid slope =
        make_grid(201, 201, [&](int column, int) { return rise * 10 * column; });
    const SkyView view = sky_view(slope, spaced(10, 10), 64);
    const double expected = (1 + 1 / std::sqrt(1 + rise * rise)) / 2;
    EXPECT_NEAR(view.at({60, 100}), expected, 0.006) << rise;
  }
}

// Every point of a sphere sees every other part of it alike: half of it is open.
TEST(SkyView, InAHemisphericalBowlIsOneHalf) {
  constexpr double kRadius = 200;
  const HeightGrid bowl = make_grid(501, 501, [](int column, int row) {
    const double r = std::hypot(column - 250, row - 250);
    return r < kRadius ? kRadius - std::sqrt(kRadius * kRadius - r * r) : kRadius;
  });
  const SkyView view = sky_view(bowl, spaced(1, 1), 32);
  EXPECT_NEAR(view.at({250, 250}), 0.5, 0.004);
  EXPECT_NEAR(view.at({300, 270}), 0.5, 0.006);
  EXPECT_NEAR(view.at({215, 150}), 0.5, 0.006);
  EXPECT_NEAR(view.at({475, 475}), 1, 1e-3);
}

HeightGrid rough(std::uint32_t seed, double amplitude_m) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> noise(-0.1, 0.1);
  return make_grid(90, 70, [&](int column, int row) {
    return amplitude_m * (std::sin(column * 0.31) * std::cos(row * 0.23) +
                          0.3 * std::sin(column * 0.9 + row * 0.7) + noise(random));
  });
}

TEST(SkyView, AgreesWithEveryHorizonByBruteForce) {
  for (const glm::dmat2& jacobian : {spaced(60, 90), glm::dmat2(0.012, 0.004, 0.003, -0.01)}) {
    const HeightGrid grid = rough(3, 150);
    const SkyView view = sky_view(grid, jacobian, 32);
    double squares = 0;
    int count = 0;
    for (int row = 1; row < grid.rows - 1; row += 3) {
      for (int column = 1; column < grid.columns - 1; column += 3) {
        const double expected = brute_force(grid, jacobian, {column, row}, 32);
        const double error = view.at({column, row}) - expected;
        EXPECT_LT(std::abs(error), 0.08) << column << ' ' << row << ' ' << expected;
        squares += error * error;
        ++count;
      }
    }
    EXPECT_LT(std::sqrt(squares / count), 0.012);
  }
}

TEST(SkyView, ConvergesWithTheNumberOfAzimuths) {
  const HeightGrid grid = rough(5, 150);
  const SkyView many = sky_view(grid, spaced(60, 90), 256);
  double last = 1;
  for (const int azimuths : {8, 16, 32}) {
    const SkyView view = sky_view(grid, spaced(60, 90), azimuths);
    double squares = 0;
    for (std::size_t i = 0; i < view.shares.size(); ++i)
      squares += (view.shares[i] - many.shares[i]) * (view.shares[i] - many.shares[i]);
    const double rms = std::sqrt(squares / static_cast<double>(view.shares.size()));
    EXPECT_LT(rms, last);
    last = rms;
  }
  EXPECT_LT(last, 0.008);
}

TEST(SkyView, OfExaggeratedGroundIsThatOfHigherGround) {
  const HeightGrid low = rough(7, 50);
  HeightGrid high = low;
  for (float& height_m : high.heights_m) height_m *= 3;
  const SkyView exaggerated = sky_view(low, spaced(60, 60), 16, 3);
  const SkyView expected = sky_view(high, spaced(60, 60), 16);
  for (std::size_t i = 0; i < expected.shares.size(); ++i)
    EXPECT_NEAR(exaggerated.shares[i], expected.shares[i], 1e-4);
}

TEST(SkyView, IsOneWhereThereIsNoGroundWhichHidesNothing) {
  HeightGrid holed = make_grid(30, 30, [](int, int) { return 10.0; });
  for (int row = 10; row < 20; ++row)
    holed.heights_m[static_cast<std::size_t>(row * 30 + 12)] = kVoid;
  for (const float share : sky_view(holed, spaced(10, 10), 16).shares) EXPECT_NEAR(share, 1, 1e-5);
}

}  // namespace
}  // namespace terrview

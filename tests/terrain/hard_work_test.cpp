// The work of rays, eyes and grids that break tracers, each by name, under every surface model: the
// pyramid gives the plain search's answers to the bit, and its cell tests and blocks together are
// at most three times the plain search's tests.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "terrain/terrain.h"
#include "tests/support/expectations.h"
#include "tests/support/scenes.h"

namespace terrview {
namespace {

struct HardScene {
  const char* name;
  HeightGrid grid;
  Place place;
  std::vector<Ray> rays;  // in posts about the eye: scaled by the spacing
};

double plain_at_zero(int /*column*/, int /*row*/) { return 0; }

double rolling(int column, int row) {
  return 300 + 40 * std::sin(0.17 * column + 0.03 * row) + 25 * std::cos(0.11 * row);
}

// Rays of these slopes at `count` azimuths.
std::vector<Ray> fan(int count, const std::vector<double>& slopes) {
  std::vector<Ray> rays;
  for (const Ray& level : rays_all_round(count))
    for (const double slope : slopes)
      rays.push_back({{0, 0, 0}, level.direction + glm::dvec3(0, 0, slope)});
  return rays;
}

// Through posts in every direction, along lines and diagonals among them.
std::vector<Ray> towards_posts(double slope_m) {
  std::vector<Ray> rays;
  for (int i = -4; i <= 4; ++i)
    for (int j = -4; j <= 4; ++j)
      if (i != 0 || j != 0) rays.push_back({{0, 0, 0}, {i, j, slope_m * std::hypot(i, j)}});
  return rays;
}

std::vector<Ray> vertical_rays() {
  std::vector<Ray> rays;
  for (int i = -20; i <= 20; ++i)
    for (const double up : {-1.0, 1.0}) rays.push_back({{0.25 * i, 0.5 * i, 0}, {0, 0, up}});
  for (const double sideways : {1e-300, 1e-15, 1e-9, 1e-6})
    rays.push_back({{0, 0, 0}, {sideways, -sideways, -1}});
  return rays;
}

const std::vector<double> kSlopes{-1, -0.3, -0.1, -0.03, -0.01, -1e-3, 0, 1e-3, 0.01, 0.1};

std::vector<HardScene> scenes_of_eyes_and_rays() {
  const HeightGrid plain = make_grid(200, 200, plain_at_zero);
  const HeightGrid hills = make_grid(200, 200, rolling);
  const double ground_m = hills.at(90, 110);
  return {
      {"rays along lines and diagonals and through posts",
       hills,
       {.eye_uv = {90, 110}, .spacing_m = {30, 30}, .eye_height_m = ground_m + 40},
       towards_posts(-0.02)},
      {"level rays along lines and diagonals",
       hills,
       {.eye_uv = {90, 110}, .spacing_m = {30, 30}, .eye_height_m = ground_m + 40},
       towards_posts(0)},
      {"flat ground grazed at a ten millionth",
       plain,
       {.eye_uv = {90.3, 110.6}, .spacing_m = {200, 200}, .eye_height_m = 1e-3},
       fan(90, {-1e-7, 1e-7})},
      {"vertical rays",
       hills,
       {.eye_uv = {90.3, 110.6}, .spacing_m = {30, 30}, .eye_height_m = ground_m + 200},
       vertical_rays()},
      {"an eye on a post",
       hills,
       {.eye_uv = {90, 110}, .spacing_m = {30, 30}, .eye_height_m = ground_m},
       fan(90, kSlopes)},
      {"an eye on an edge",
       plain,
       {.eye_uv = {90, 110.5}, .spacing_m = {30, 30}, .eye_height_m = 0},
       fan(90, kSlopes)},
      {"an eye a millimetre above the ground",
       hills,
       {.eye_uv = {90, 110}, .spacing_m = {30, 30}, .eye_height_m = ground_m + 1e-3},
       fan(90, kSlopes)},
      {"an eye 400 km up",
       hills,
       {.eye_uv = {90.3, 110.6}, .spacing_m = {30, 30}, .eye_height_m = 4e5},
       fan(45, {-1e6, -4000, -800, -300, -150, -130})},
  };
}

HeightGrid spike() {
  return make_grid(200, 200, [](int c, int r) { return c == 131 && r == 59 ? 100 : 0; });
}

HeightGrid cliff() {
  return make_grid(200, 200, [](int c, int /*r*/) { return c < 140 ? 0 : 1e4; });
}

HeightGrid with_voids(const std::function<bool(int, int)>& is_void) {
  return make_grid(200, 200,
                   [&](int c, int r) -> double { return is_void(c, r) ? kVoid : rolling(c, r); });
}

std::vector<HardScene> scenes_of_grids() {
  std::vector<HardScene> scenes;
  for (const double cell_m : {1000.0, 0.01})
    scenes.push_back({cell_m > 1 ? "a spike in a plain of 1 km cells" : "of 1 cm cells",
                      spike(),
                      {.eye_uv = {70.4, 120.7}, .spacing_m = {cell_m, cell_m}, .eye_height_m = 50},
                      fan(180, {-100 / cell_m, -10 / cell_m, -0.5 / cell_m, 0, 0.3 / cell_m})});
  scenes.push_back({"a cliff of 10 km in one cell",
                    cliff(),
                    {.eye_uv = {30.4, 90.3}, .spacing_m = {30, 30}, .eye_height_m = 5000},
                    fan(180, {-2, -0.5, 0, 0.5, 1.4, 1.6})});
  scenes.push_back(
      {"millimetre relief at coordinates of 1e6 m",
       make_grid(200, 200, [](int c, int r) { return 1e6 + 1e-3 * ((c + 2 * r) % 3); }),
       {.eye_uv = {90.3, 110.6}, .spacing_m = {1, 1}, .eye_height_m = 1e6 + 0.5},
       fan(180, {-0.1, -0.01, -0.004, 0, 0.01})});
  for (const double z_scale : {1e-3, 1e3})
    scenes.push_back({z_scale < 1 ? "heights scaled by 1e-3" : "heights scaled by 1e3",
                      make_grid(200, 200, rolling),
                      {.eye_uv = {90.3, 110.6},
                       .spacing_m = {30, 30},
                       .eye_height_m = 380 * z_scale,
                       .z_scale = z_scale},
                      fan(90, {-3 * z_scale, -0.1 * z_scale, -0.01 * z_scale, 0, 0.1 * z_scale})});
  scenes.push_back({"equal heights",
                    make_grid(200, 200, [](int, int) { return 700; }),
                    {.eye_uv = {90.3, 110.6}, .spacing_m = {30, 30}, .eye_height_m = 720},
                    fan(90, kSlopes)});
  scenes.push_back({"voids under the track",
                    with_voids([](int c, int r) { return (c / 9 + r / 7) % 3 == 0; }),
                    {.eye_uv = {90.3, 110.6}, .spacing_m = {30, 30}, .eye_height_m = 420},
                    fan(90, kSlopes)});
  scenes.push_back({"a border of voids",
                    with_voids([](int c, int r) { return c < 20 || r < 20 || c > 180 || r > 180; }),
                    {.eye_uv = {90.3, 110.6}, .spacing_m = {30, 30}, .eye_height_m = 420},
                    fan(90, kSlopes)});
  scenes.push_back({"2 x 2 posts",
                    make_grid(2, 2, [](int c, int r) { return 3 * c - 2 * r; }),
                    {.eye_uv = {0.4, 0.7}, .eye_height_m = 5},
                    fan(90, {-30, -10, -3, -1, 0})});
  scenes.push_back({"a checkerboard of a kilometre",
                    make_grid(200, 200, [](int c, int r) { return (c + r) % 2 == 0 ? 0 : 1000; }),
                    {.eye_uv = {90.3, 110.6}, .spacing_m = {30, 30}, .eye_height_m = 1100},
                    fan(180, {-3, -1, -0.3, -0.1, -0.05, -0.03, 0})});
  scenes.push_back({"heights of 1e30",
                    make_grid(200, 200, [](int c, int r) { return 1e30 * ((c * 7 + r * 5) % 11); }),
                    {.eye_uv = {90.3, 110.6}, .spacing_m = {1e29, 1e29}, .eye_height_m = 1.2e31},
                    fan(90, {-3, -1, -0.3, -0.1, 0})});
  return scenes;
}

class HardWork : public ModelTest {
 protected:
  static void expect_little_work(const HardScene& scene) {
    SCOPED_TRACE(scene.name);
    const Terrain terrain = make_terrain(scene.grid, scene.place, GetParam());
    const Terrain plain(terrain.layers(), terrain.frame(), GetParam(), Search::plain);
    TraceCounts work;
    TraceCounts plain_work;
    for (const Ray& unscaled : scene.rays) {
      Ray ray = unscaled;
      ray.origin_m *= glm::dvec3(scene.place.spacing_m, 1);
      const auto hit = terrain.first_hit(ray, &work);
      const auto expected = plain.first_hit(ray, &plain_work);
      ASSERT_EQ(hit.has_value(), expected.has_value()) << oracle::to_string(ray);
      if (hit) {
        EXPECT_EQ(hit->distance_m, expected->distance_m) << oracle::to_string(ray);
        EXPECT_EQ(hit->cell, expected->cell) << oracle::to_string(ray);
      }
      EXPECT_EQ(terrain.occluded(ray, &work), plain.occluded(ray, &plain_work))
          << oracle::to_string(ray);
    }
    EXPECT_GT(plain_work.tests, 0);
    EXPECT_LE(work.tests + work.nodes, 3 * plain_work.tests)
        << work.tests << " tests and " << work.nodes << " blocks beside " << plain_work.tests;
  }
};

TEST_P(HardWork, OfHardRaysAndEyesIsAtMostThreeTimesThatOfThePlainSearch) {
  for (const HardScene& scene : scenes_of_eyes_and_rays()) expect_little_work(scene);
}

TEST_P(HardWork, OfHardGridsIsAtMostThreeTimesThatOfThePlainSearch) {
  for (const HardScene& scene : scenes_of_grids()) expect_little_work(scene);
}

INSTANTIATE_TEST_SUITE_P(Models, HardWork, testing::ValuesIn(kSurfaceModels), model_name);

}  // namespace
}  // namespace terrview

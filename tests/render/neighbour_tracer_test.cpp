// What the thesis's rule finds, and what it misses: render/neighbour_tracer.h.
#include "render/neighbour_tracer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include <glm/geometric.hpp>

#include "tests/render/hills.h"

namespace terrview {
namespace {

struct Compared {
  int pixels = 0;
  int hits = 0;
  int differ = 0;  // from the ray on its own, bit for bit
  double tests_per_ray = 0;

  [[nodiscard]] double share() const { return static_cast<double>(differ) / pixels; }
};

Compared compare(const Terrain& terrain, const Camera& camera) {
  TraceCounts counts;
  const auto hits = trace_by_neighbours(terrain, camera, 0, counts);
  Compared compared;
  for (int row = 0; row < hits.height_px(); ++row)
    for (int column = 0; column < hits.width_px(); ++column) {
      ++compared.pixels;
      const auto expected = terrain.first_hit(camera.ray({column + 0.5, row + 0.5}));
      const auto& found = hits.at(column, row);
      compared.hits += expected ? 1 : 0;
      const bool same = found.has_value() == expected.has_value() &&
                        (!found || (found->distance_m == expected->distance_m &&
                                    found->cell == expected->cell && found->uv == expected->uv));
      compared.differ += same ? 0 : 1;
    }
  compared.tests_per_ray = static_cast<double>(counts.tests) / compared.pixels;
  return compared;
}

HeightGrid smooth_grid() {
  return make_grid(200, 200, [](int column, int row) {
    return 300 + 80 * std::sin(column * 0.06) * std::cos(row * 0.05);
  });
}

Terrain smooth_terrain(double eye_height_m) {
  const Place place{.eye_uv = {99.3, 99.6}, .spacing_m = {30, 30}, .eye_height_m = eye_height_m};
  return make_terrain(smooth_grid(), place, SurfaceModel::hyperboloid);
}

struct View {
  const char* name;
  double pitch_deg;
  double roll_deg;
};

class NeighboursOverSmoothGround : public testing::TestWithParam<View> {};

// Where the ground does not vary within a pixel, the rule's condition holds but at skylines.
TEST_P(NeighboursOverSmoothGround, AreWrongInOnePixelOfAThousandAtMost) {
  const Terrain terrain = smooth_terrain(600);
  const Camera camera({.heading_rad = 0.4,
                       .pitch_rad = GetParam().pitch_deg * kRadians,
                       .roll_rad = GetParam().roll_deg * kRadians,
                       .size_px = {160, 120}});
  const Compared compared = compare(terrain, camera);
  EXPECT_LE(compared.share(), 1e-3);
  EXPECT_LE(compared.tests_per_ray, 2.5);
  RecordProperty("differ", compared.differ);
}

INSTANTIATE_TEST_SUITE_P(Views, NeighboursOverSmoothGround,
                         testing::Values(View{"OeInTheMiddle", -90, 0}, View{"OeInside", -75, 20},
                                         View{"OeOnTheEdge", -66.59, 0}, View{"OeOutside", -35, 0},
                                         View{"OeOutsideAndRolled", -35, 33},
                                         View{"OeFarAway", -2, 10}, View{"OeAtInfinity", 0, 10},
                                         View{"OeAtInfinityUpsideDown", 0, 180},
                                         View{"Ascending", 5, 25},
                                         View{"AscendingWithOeAtInfinity", 1e-9, 70}),
                         [](const auto& view) { return std::string(view.param.name); });

// Columns that are vertical planes have one forerunner a pixel: nothing can be missed.
TEST(Neighbours, AreExactWithinOneVerticalPlane) {
  const Scene scene = hills_scene();
  for (const double roll_deg : {0.0, 90.0, 180.0, 270.0}) {
    const Camera camera({.roll_rad = roll_deg * kRadians, .size_px = {120, 90}});
    const Compared compared = compare(*scene.terrain, camera);
    EXPECT_LE(compared.share(), roll_deg == 0 ? 0 : 0.002) << roll_deg;
    EXPECT_GT(compared.hits, 2000);
  }
}

// One post stands up between two neighbouring rays, which see the plain beyond it.
TEST(Neighbours, MissAPeakThinnerThanAPixel) {
  const glm::ivec2 peak_post(64, 90);
  const HeightGrid grid = make_grid(129, 200, [&](int column, int row) {
    return glm::ivec2(column, row) == peak_post ? 200 : 0;
  });
  const Place place{.eye_uv = {64, 190}, .spacing_m = {10, 10}, .eye_height_m = 150};
  const Terrain terrain = make_terrain(grid, place, SurfaceModel::hyperboloid);
  // The ray of pixel (14, 8) goes over the peak's post, a kilometre away.
  CameraOptions options{.pitch_rad = -3 * kRadians, .roll_rad = 20 * kRadians, .size_px = {24, 18}};
  const glm::ivec2 pixel(14, 8);
  const glm::dvec3 ahead = Camera(options).ray(glm::dvec2(pixel) + 0.5).direction;
  options.heading_rad = -std::atan2(ahead.x, ahead.y);
  const Camera camera(options);
  const auto exact = terrain.first_hit(camera.ray(glm::dvec2(pixel) + 0.5));
  ASSERT_TRUE(exact);
  EXPECT_NEAR(exact->uv.y, peak_post.y, 1);
  TraceCounts counts;
  const auto hits = trace_by_neighbours(terrain, camera, 1, counts);
  const auto& found = hits.at(pixel.x, pixel.y);
  EXPECT_TRUE(!found || found->distance_m > exact->distance_m + 10);
}

TEST(Neighbours, AreTheSameForAnyNumberOfThreads) {
  const Scene scene = hills_scene();
  const Camera camera = tilted_camera({90, 70});
  TraceCounts alone;
  const auto one = trace_by_neighbours(*scene.terrain, camera, 1, alone);
  for (const int threads : {2, 3, 8}) {
    TraceCounts counts;
    const auto many = trace_by_neighbours(*scene.terrain, camera, threads, counts);
    EXPECT_EQ(counts.tests, alone.tests);
    EXPECT_EQ(counts.nodes, alone.nodes);
    for (int row = 0; row < 70; ++row)
      for (int column = 0; column < 90; ++column) {
        const auto& a = one.at(column, row);
        const auto& b = many.at(column, row);
        ASSERT_EQ(a.has_value(), b.has_value());
        if (a) {
          ASSERT_EQ(a->distance_m, b->distance_m);
        }
      }
  }
}

TEST(Neighbours, ServeEverySurface) {
  for (const SurfaceModel model : kSurfaceModels) {
    const Place place{.eye_uv = {99.3, 150}, .spacing_m = {30, 30}, .eye_height_m = 500};
    const Compared compared =
        compare(make_terrain(smooth_grid(), place, model), tilted_camera({80, 60}));
    EXPECT_LE(compared.share(), 1e-3) << name_of(model);
    EXPECT_GT(compared.hits, 1000);
  }
}

TEST(Neighbours, MakeThePictureOfTheirHits) {
  const Scene scene = hills_scene();
  const Camera camera = tilted_camera({60, 40});
  const Frame frame =
      render(scene, camera, {.coherence = Coherence::neighbours, .keep_samples = true});
  TraceCounts counts;
  const auto hits = trace_by_neighbours(*scene.terrain, camera, 0, counts);
  EXPECT_EQ(frame.counts.tests, counts.tests);
  for (int row = 0; row < 40; ++row)
    for (int column = 0; column < 60; ++column) {
      const auto& hit = hits.at(column, row);
      const PixelSample& sample = frame.samples.at(column, row);
      ASSERT_EQ(sample.object_id != PixelSample::kNothing, hit.has_value());
      if (hit) {
        EXPECT_EQ(sample.position_m, hit->position_m);
      }
    }
}

}  // namespace
}  // namespace terrview

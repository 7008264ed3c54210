// Rays from the eye, many at a time, over grids in degrees: eyes over them, over their border and
// corner, beside them and far away.
#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "ingest/view_frame.h"
#include "terrain/eye_tracks.h"
#include "tests/ingest/geodesy_cases.h"
#include "tests/support/eye_rays.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/random_scene.h"

namespace terrview {
namespace {

using cases::GridCase;

constexpr glm::dvec2 kEyeShares[] = {{0.4, 0.6},   {0, 0.3},   {1, 1},  {1.02, 0.5},
                                     {-0.3, -0.2}, {0.5, 2.4}, {-3, -2}};

GridCase arc_seconds(glm::dvec2 eye_share) {
  return {"arc seconds", "EPSG:4326", {6.5, 48.6}, 1.0 / 1200, {300, 250}, eye_share};
}

ViewFrame frame(const GridCase& grid, double eye_height_m) {
  const EyePlace eye{.geographic = {},
                     .projected = cases::placement(grid).at(cases::eye_uv(grid)),
                     .height_m = eye_height_m,
                     .above_ground = false};
  return {{cases::dem(grid, 300)}, eye, {}};
}

// At posts, a little beside them, and some away from the grid.
std::vector<glm::dvec3> directions_to_posts(const Terrain& terrain, int count) {
  const TerrainLayer& layer = terrain.layers()[0];
  Random random(21);
  std::vector<glm::dvec3> directions;
  while (static_cast<int>(directions.size()) < count) {
    const glm::dvec2 last(layer.grid->columns - 1, layer.grid->rows - 1);
    const glm::dvec2 uv = last * glm::dvec2(random.uniform(-0.1, 1.1), random.uniform(-0.1, 1.1));
    const glm::dvec2 ground_m = ground_at(*layer.map, uv);
    directions.emplace_back(ground_m, terrain.frame().at(ground_m).z_m(random.uniform(-50, 350)));
  }
  return directions;
}

void expect_hits_of_single_rays_from(glm::dvec2 eye_share, double eye_height_m, int count) {
  const ViewFrame view = frame(arc_seconds(eye_share), eye_height_m);
  const Terrain& terrain = *view.terrain();
  ASSERT_NE(terrain.layers()[0].map->eye_tracks(), nullptr);
  ASSERT_TRUE(EyeFront::serves(terrain));
  const EyeFront front(terrain, {.wedge_rad = 0.003});
  EXPECT_GT(expect_hits_of_single_rays(front, directions_to_posts(terrain, count)), count / 4);
}

TEST(EyeRaysOverDegrees, MeetTheGroundAsSingleRaysDo) {
  for (const glm::dvec2 eye_share : kEyeShares)
    for (const double eye_height_m : {400.0, 6000.0}) {
      SCOPED_TRACE(testing::Message() << eye_share.x << ", " << eye_share.y);
      expect_hits_of_single_rays_from(eye_share, eye_height_m, 4000);
    }
}

TEST(EyeRaysOverDegrees, DoSoUnderEveryInstructionSet) {
  under_every_instruction_set([] {
    expect_hits_of_single_rays_from(kEyeShares[0], 2000, 1500);
    expect_hits_of_single_rays_from(kEyeShares[4], 2000, 1500);
  });
}

// A level picture: each row of rays begins where the row below it ended.
TEST(EyeRaysOverDegrees, DoSoWhereTheyFollowOthers) {
  const ViewFrame view = frame(arc_seconds(kEyeShares[4]), 2000);
  const Terrain& terrain = *view.terrain();
  const EyeFront front(terrain, {.wedge_rad = 0.003});
  const glm::dvec2 middle = ground_at(*terrain.layers()[0].map, {150, 125});
  const auto rays = std::make_unique<EyeRays>();
  rays->begin_to_follow();
  int met = 0;
  for (int row = 0; row < 60; ++row) {
    rays->count = 300;
    for (std::size_t i = 0; i < rays->count; ++i) {
      const double turn = 0.004 * (static_cast<double>(i) - 150);
      const glm::dvec2 across =
          glm::normalize(middle) + turn * glm::normalize(glm::dvec2(-middle.y, middle.x));
      rays->aim(i, {across, -0.2 + 0.004 * row});
    }
    TraceCounts counts;
    trace(front, *rays, counts);
    for (std::size_t i = 0; i < rays->count; ++i) {
      const Ray ray{
          .direction = {rays->direction_x[i], rays->direction_y[i], rays->direction_z[i]}};
      const auto expected = terrain.first_hit(ray);
      ASSERT_EQ(rays->is_hit(i), expected.has_value()) << oracle::to_string(ray);
      if (expected) expect_same_hit(rays->hit(i), *expected, ray);
      met += expected ? 1 : 0;
    }
  }
  EXPECT_GT(met, 5000);
}

// Tests of rays that meet the ground beside the first knots of their tracks, which are those of the
// round Earth's.
class RaysBesideKnots {
 public:
  explicit RaysBesideKnots(EarthModel earth)
      : round_(view(EarthModel::curved)), view_(view(earth)) {}

  [[nodiscard]] std::int64_t tests(bool looks_at_lines) const {
    const EyeTracks* tracks = round_.terrain()->layers()[0].map->eye_tracks();
    if (!tracks) throw std::runtime_error("the round Earth's tracks have no table");
    const std::vector<double>& knots_m = tracks->knots_m();
    const EyeFront front(*view_.terrain(), {.wedge_rad = 0.003, .looks_at_lines = looks_at_lines});
    const auto rays = std::make_unique<EyeRays>();
    rays->count = EyeRays::kMost;
    Random random(23);
    TraceCounts counts;
    for (int batch = 0; batch < 20; ++batch) {
      for (std::size_t i = 0; i < rays->count; ++i) {
        const double azimuth_rad = random.uniform(-3.14, 3.14);
        const double g_m = knots_m.at(1 + i % 3) + random.uniform(-150, 150);
        rays->aim(i, {g_m * std::sin(azimuth_rad), g_m * std::cos(azimuth_rad), -2990});
      }
      trace(front, *rays, counts);
    }
    return counts.tests;
  }

 private:
  static ViewFrame view(EarthModel earth) {
    const GridCase grid = arc_seconds(kEyeShares[0]);
    const EyePlace eye{.geographic = {},
                       .projected = cases::placement(grid).at(cases::eye_uv(grid)),
                       .height_m = 3000,
                       .above_ground = false};
    return {{cases::dem(grid, 20)}, eye, {.earth = earth}};
  }

  ViewFrame round_;
  ViewFrame view_;
};

// Rays that floats cannot tell are traced twice: few, and those beside the knots of their tracks
// are not among them.
TEST(EyeRaysOverDegrees, TakeHardlyMoreTestsThanOverAStraightGrid) {
  const RaysBesideKnots bent(EarthModel::curved);
  const RaysBesideKnots straight(EarthModel::flat);
  for (const bool looks_at_lines : {false, true})
    EXPECT_LT(static_cast<double>(bent.tests(looks_at_lines)),
              1.1 * static_cast<double>(straight.tests(looks_at_lines)))
        << looks_at_lines;
}

}  // namespace
}  // namespace terrview

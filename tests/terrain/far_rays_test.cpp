// Rays that single precision can hardly tell from others: to posts and edges thousands of posts
// away, and by less and less beside them, above them and below.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "terrain/eye_tracer.h"
#include "tests/support/eye_rays.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/parabolic_map.h"
#include "tests/support/random_scene.h"
#include "tests/support/scenes.h"

namespace terrview {
namespace {

constexpr double kPost_m = 10;
const glm::dvec2 kEye_uv{3.3, 4.4};
constexpr int kPosts = 2500;  // a side
constexpr double kEyeHeight_m = 300;
constexpr int kWall = 2000;  // its column

// A wall on a plain, level from post to post, then a step up or down.
HeightGrid wall() {
  Random random(11);
  double top_m = 0;
  return make_grid(kPosts, kPosts, [&](int column, int row) {
    if (column != kWall) return 0.0;
    if (row % 2 == 0) top_m = random.uniform(0, 500);
    return top_m;
  });
}

VerticalFrame flat() { return {.eye_height_m = kEyeHeight_m}; }
VerticalFrame round_earth() {
  return {.eye_height_m = kEyeHeight_m,
          .north_curvature_per_m = 1 / 6.36e6,
          .east_curvature_per_m = 1 / 6.39e6,
          .refraction = 0.13};
}

Terrain wall_on(std::shared_ptr<const GroundMap> map, const VerticalFrame& frame) {
  return {{{.grid = std::make_shared<const HeightGrid>(wall()), .map = std::move(map)}},
          frame,
          SurfaceModel::hyperboloid};
}

// Askew, so that places on the grid are sums of what nearly cancels.
std::shared_ptr<const GroundMap> straight() {
  constexpr double kTurn_rad = 0.7;
  const glm::dvec2 along(std::cos(kTurn_rad), std::sin(kTurn_rad));
  return std::make_shared<const AffineGroundMap>(
      kEye_uv, glm::dmat2(along.x, -along.y, -along.y, -along.x) / kPost_m,
      glm::ivec2(kPosts, kPosts));
}

// Beside a post, or a point of an edge.
glm::dvec3 direction_beside(Random& random, const Terrain& terrain) {
  const TerrainLayer& layer = terrain.layers()[0];
  const glm::ivec2 post(kWall, random.integer(5, kPosts - 5));
  const glm::dvec2 along = random.chance(0.2) ? glm::dvec2(1, 0) : glm::dvec2(0, 1);
  const double share = random.chance(0.5) ? 0 : random.uniform(0, 1);
  const glm::dvec2 aside(along.y, along.x);
  const glm::dvec2 uv = glm::dvec2(post) + share * along +
                        random.sign() * random.log_uniform(1e-7, 1e-2) * aside +
                        random.sign() * random.log_uniform(1e-7, 1e-2) * along;
  const glm::dvec2 ground_m = ground_at(*layer.map, uv);
  const auto height = [&](glm::ivec2 at) {
    return static_cast<double>(layer.grid->at(at.x, at.y));
  };
  const double top_m = height(post) + share * (height(post + glm::ivec2(along)) - height(post));
  const double aim_m = top_m + random.sign() * random.log_uniform(1e-4, 0.2);
  return {ground_m, terrain.frame().at(ground_m).z_m(aim_m)};
}

// Aims a batch after the other, and expects the hits of single rays. Returns how many there are.
template <class Aim>
int expect_hits_of_single_rays(const Terrain& terrain, EyeRays& rays, int batches, const Aim& aim) {
  const EyeFront front(terrain, {.wedge_rad = 0.001});
  int met = 0;
  for (int batch = 0; batch < batches; ++batch) {
    rays.count = EyeRays::kMost;
    for (std::size_t i = 0; i < rays.count; ++i) rays.aim(i, aim(i));
    TraceCounts counts;
    trace(front, rays, counts);
    for (std::size_t i = 0; i < rays.count; ++i) {
      const Ray ray{.direction = {rays.direction_x[i], rays.direction_y[i], rays.direction_z[i]}};
      const auto expected = terrain.first_hit(ray);
      EXPECT_EQ(rays.is_hit(i), expected.has_value()) << oracle::to_string(ray);
      if (!expected || !rays.is_hit(i)) continue;
      expect_same_hit(rays.hit(i), *expected, ray);
      ++met;
    }
    if (testing::Test::HasFailure()) break;
  }
  return met;
}

void expect_hits_of_single_rays(const Terrain& terrain) {
  ASSERT_TRUE(EyeFront::serves(terrain));
  Random random(12);
  const auto rays = std::make_unique<EyeRays>();
  const auto aim = [&](std::size_t /*i*/) { return direction_beside(random, terrain); };
  EXPECT_GT(expect_hits_of_single_rays(terrain, *rays, 60, aim), 10000);
}

TEST(FarRays, MeetTheGroundAsSingleRaysDoOnAFlatEarth) {
  const Terrain terrain = wall_on(straight(), flat());
  under_every_instruction_set([&] { expect_hits_of_single_rays(terrain); });
}

TEST(FarRays, MeetTheGroundAsSingleRaysDoOnARoundEarth) {
  expect_hits_of_single_rays(wall_on(straight(), round_earth()));
}

TEST(FarRays, MeetTheGroundAsSingleRaysDoOnBentTracks) {
  expect_hits_of_single_rays(wall_on(
      std::make_shared<const ParabolicGroundMap>(kEye_uv, kPost_m, 2e-8, 45000.0), round_earth()));
}

// Each row of rays begins where the row below it ended.
TEST(FarRays, ThatFollowOthersUpwardsMeetTheGroundAsSingleRaysDo) {
  for (const VerticalFrame& frame : {flat(), round_earth()}) {
    const Terrain terrain = wall_on(straight(), frame);
    Random random(13);
    std::vector<glm::dvec3> directions;
    while (directions.size() < EyeRays::kMost) {
      directions.push_back(direction_beside(random, terrain));
      directions.back().z = terrain.frame().at(glm::dvec2(directions.back())).z_m(-200);
    }
    const auto rays = std::make_unique<EyeRays>();
    rays->begin_to_follow();
    const auto rise = [&](std::size_t i) {
      directions[i].z += random.log_uniform(1e-3, 60);
      return directions[i];
    };
    EXPECT_GT(expect_hits_of_single_rays(terrain, *rays, 60, rise), 10000);
  }
}

}  // namespace
}  // namespace terrview

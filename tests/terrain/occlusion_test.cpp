#include "terrain/occlusion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "tests/support/instruction_sets.h"
#include "tests/support/judge.h"
#include "tests/support/parabolic_map.h"
#include "tests/support/random_scene.h"
#include "tests/support/scenes.h"

namespace terrview {
namespace {

// Anywhere, and from the ground towards a few suns, as shadows go.
std::vector<Ray> random_rays(Random& random, const Terrain& terrain, Position position) {
  std::vector<Ray> rays;
  std::vector<glm::dvec3> suns;
  for (int i = 0; i < 3; ++i) suns.push_back(random_ray(random, terrain, position).direction);
  while (rays.size() < 300) {
    const Ray ray = random_ray(random, terrain, position);
    rays.push_back(ray);
    const auto hit = terrain.first_hit(ray);
    if (!hit) continue;
    for (glm::dvec3 sun : suns) {
      if (random.chance(0.7)) sun.z = std::abs(sun.z);
      rays.push_back(terrain.leave(*hit, sun));
    }
  }
  return rays;
}

struct Answers {
  int stopped = 0;
  int free = 0;
};

void expect_answers_of_single_rays(const Terrain& terrain, const std::vector<Ray>& rays,
                                   Answers& answers) {
  std::vector<std::uint8_t> stopped(rays.size());
  TraceCounts counts;
  occluded(terrain, rays, stopped, counts);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const bool expected = terrain.occluded(rays[i]);
    EXPECT_EQ(stopped[i] != 0, expected) << oracle::to_string(rays[i]);
    ++(expected ? answers.stopped : answers.free);
  }
}

template <class MakeTerrain>
void expect_same_answers(std::uint64_t seed, Position position, const MakeTerrain& make) {
  Random random(seed);
  Answers answers;
  for (int i = 0; i < 300; ++i) {
    const Terrain terrain = make(random);
    expect_answers_of_single_rays(terrain, random_rays(random, terrain, position), answers);
    ASSERT_FALSE(testing::Test::HasFailure()) << "seed " << seed << ", terrain " << i;
  }
  EXPECT_GT(answers.stopped, 10000);
  EXPECT_GT(answers.free, 10000);
}

TEST(Occluded, AnswersAsSingleRaysDo) {
  expect_same_answers(1, Position::general, [](Random& random) {
    return random_terrain(random, SurfaceModel::hyperboloid, Position::general);
  });
}

TEST(Occluded, AnswersSoThroughPostsAndAlongLines) {
  expect_same_answers(2, Position::special, [](Random& random) {
    return random_terrain(random, SurfaceModel::hyperboloid, Position::special);
  });
}

TEST(Occluded, AnswersSoOnBentTracks) {
  expect_same_answers(3, Position::general, [](Random& random) {
    return random_parabolic_terrain(random, SurfaceModel::hyperboloid);
  });
}

TEST(Occluded, AnswersSoWhereTracksComeBack) {
  expect_same_answers(4, Position::general, [](Random& random) {
    return random_bent_terrain(random, SurfaceModel::hyperboloid);
  });
}

// Lines that miss the disc of the reach, graze it, enter it and leave it, with ground on both
// sides.
TEST(Occluded, AnswersSoBeyondTheReach) {
  constexpr double kReach_m = 1000;
  Random random(23);
  const auto grid = std::make_shared<const HeightGrid>(make_grid(
      301, 301, [&](int, int) { return random.chance(0.05) ? 200.0 : random.uniform(0, 5); }));
  const auto map =
      std::make_shared<const ParabolicGroundMap>(glm::dvec2(150.3, 149.6), 10, 1e-5, kReach_m);
  const Terrain terrain({{grid, map}}, {.eye_height_m = 100}, SurfaceModel::hyperboloid);
  std::vector<Ray> rays;
  while (rays.size() < 20000) {
    const double azimuth_rad = random.uniform(0, 6.3);
    const double away_m = random.uniform(900, 1400);
    const double heading_rad =
        random.chance(0.3) ? azimuth_rad + std::acos(-1) / 2 : random.uniform(0, 6.3);
    const glm::dvec2 at_m = away_m * glm::dvec2(std::sin(azimuth_rad), std::cos(azimuth_rad));
    const double z_m = random.uniform(-90, 80);
    rays.push_back(
        {{at_m, z_m}, {std::sin(heading_rad), std::cos(heading_rad), random.uniform(-0.01, 0.1)}});
  }
  Answers answers;
  expect_answers_of_single_rays(terrain, rays, answers);
  EXPECT_GT(answers.stopped, 2000);
  EXPECT_GT(answers.free, 2000);
}

TEST(Occluded, AnswersSoOverSeveralGridsAndOtherSurfaces) {
  expect_same_answers(5, Position::general, [](Random& random) {
    return random_layers(random, SurfaceModel::hyperboloid);
  });
  for (const SurfaceModel model : kSurfaceModels) {
    expect_same_answers(6, Position::general, [&](Random& random) {
      return random_terrain(random, model, Position::general);
    });
  }
}

// Hills of 200 m, posts 30 m apart, far from the eye.
Terrain wide_hills(double eye_east_posts, const VerticalFrame& frame) {
  constexpr int kPosts = 500;
  const auto height_m = [](int column, int row) {
    return 300 + 100 * (std::sin(column * 0.07) + std::cos(row * 0.05 + 0.02 * column)) +
           3 * std::sin(column * 0.9 + row * 1.3);
  };
  const Place place{.eye_uv = {eye_east_posts, kPosts / 2.0}, .spacing_m = {30, 30}};
  return Terrain({make_layer(make_grid(kPosts, kPosts, height_m), place)}, frame,
                 SurfaceModel::hyperboloid);
}

// From all over the ground towards a sun.
std::vector<Ray> sun_rays(const Terrain& terrain, double elevation_rad) {
  Random random(7);
  std::vector<Ray> rays;
  const double reach_m = terrain.reach_m();
  while (rays.size() < 5000) {
    const glm::dvec2 at(random.uniform(-reach_m, reach_m), random.uniform(-reach_m, reach_m));
    const auto hit = terrain.first_hit({.origin_m = {at.x, at.y, 10000}, .direction = {0, 0, -1}});
    if (!hit) continue;
    const double azimuth_rad = 2 + random.uniform(0, 0.01);
    rays.push_back(terrain.leave(
        *hit, {std::cos(elevation_rad) * std::sin(azimuth_rad),
               std::cos(elevation_rad) * std::cos(azimuth_rad), std::sin(elevation_rad)}));
  }
  return rays;
}

constexpr double kEarth_per_m = 1 / 6.37e6;

TEST(Occluded, AnswersSoFarAwayOnACurvedEarth) {
  for (const double eye_east : {100.0, -3000.0}) {
    for (const double refraction : {-1.0, 0.0, 0.13, 0.9, 1.5}) {
      const Terrain terrain = wide_hills(eye_east, {.eye_height_m = 500,
                                                    .north_curvature_per_m = 1.003 * kEarth_per_m,
                                                    .east_curvature_per_m = 0.997 * kEarth_per_m,
                                                    .refraction = refraction});
      Answers answers;
      for (const double elevation_rad : {0.005, 0.03, 0.1, 0.35, 1.2})
        expect_answers_of_single_rays(terrain, sun_rays(terrain, elevation_rad), answers);
      EXPECT_GT(answers.stopped, 1000);
      EXPECT_GT(answers.free, 1000);
    }
  }
}

// Where the curvature turns with the azimuth, the more so the higher the eye is.
TEST(Occluded, AnswersSoBelowTheEye) {
  Random random(9);
  for (const auto& [eye_m, flattening] : {std::pair(9e3, 0.01), std::pair(9e4, 0.1)}) {
    const Terrain terrain =
        wide_hills(100, {.eye_height_m = eye_m,
                         .z_scale = 4,
                         .north_curvature_per_m = (1 + flattening) * kEarth_per_m,
                         .east_curvature_per_m = (1 - flattening) * kEarth_per_m});
    ASSERT_TRUE(terrain.frame().is_convex(terrain.reach_m()));
    std::vector<Ray> rays;
    for (int i = 0; i < 5000; ++i) {
      const double away_m = random.log_uniform(1e-3, 300);
      const double azimuth_rad = random.uniform(0, 6.3);
      const glm::dvec3 below(away_m * std::sin(azimuth_rad), away_m * std::cos(azimuth_rad), 0);
      const auto hit = terrain.first_hit({.origin_m = below, .direction = {0, 0, -1}});
      ASSERT_TRUE(hit);
      const double sun_rad = random.uniform(0, 6.3);
      rays.push_back(
          terrain.leave(*hit, {std::sin(sun_rad), std::cos(sun_rad), random.uniform(0, 0.4)}));
    }
    Answers answers;
    expect_answers_of_single_rays(terrain, rays, answers);
    EXPECT_GT(answers.stopped, 1000);
    EXPECT_GT(answers.free, 1000);
  }
}

// An affine map whose tracks are cut every 300 m.
class CutGroundMap final : public GroundMap {
 public:
  explicit CutGroundMap(std::shared_ptr<const GroundMap> whole) : whole_(std::move(whole)) {}
  [[nodiscard]] glm::dvec2 to_grid(glm::dvec2 ground_m) const override {
    return whole_->to_grid(ground_m);
  }
  [[nodiscard]] glm::dmat2 jacobian(glm::dvec2 ground_m) const override {
    return whole_->jacobian(ground_m);
  }
  [[nodiscard]] double reach_m() const override { return whole_->reach_m(); }
  [[nodiscard]] double piece_end_m(const GroundLine& /*line*/, double from_m,
                                   double limit_m) const override {
    return std::min(limit_m, 300 * (std::floor(from_m / 300) + 1));
  }

 private:
  std::shared_ptr<const GroundMap> whole_;
};

TEST(Occluded, AnswersSoWhereAPieceEndsAtAWall) {
  constexpr int kWall = 40;
  const Place place{.eye_uv = {kWall, 50}, .spacing_m = {30, 30}};
  const auto height_m = [](int column, int) { return column == kWall ? 100 : 0; };
  TerrainLayer layer = make_layer(make_grid(100, 100, height_m), place);
  layer.map = std::make_shared<const CutGroundMap>(layer.map);
  const Terrain terrain({layer}, {.eye_height_m = 50}, SurfaceModel::hyperboloid);
  Random random(13);
  std::vector<Ray> rays;
  for (int i = 0; i < 20000; ++i) {
    const double azimuth_rad = random.uniform(0.8, 2.3);
    const glm::dvec2 direction(std::sin(azimuth_rad), std::cos(azimuth_rad));
    const double away_m =
        300 * random.integer(1, 2) + random.sign() * random.log_uniform(1e-9, 1e-2);
    rays.push_back({.origin_m = {-away_m * direction, 0},
                    .direction = glm::normalize(glm::dvec3(direction, 0.05))});
  }
  Answers answers;
  expect_answers_of_single_rays(terrain, rays, answers);
  EXPECT_EQ(answers.free, 0);
}

// A plain and a wall across it, two columns thick, or rows if `transposed`. Half of the wall has
// level edges, and the posts of the other half stand at 0 or 3000 m, with cliffs between them.
class FarWall {
 public:
  FarWall(int wall, bool transposed)
      : wall_(wall), transposed_(transposed), terrain_({layer()}, frame(), kModel) {}

  [[nodiscard]] const Terrain& terrain() const { return terrain_; }

  // A ray from the plain, out of any distance, to just above or below the wall's edge, often
  // beside a post; some nearly level.
  [[nodiscard]] Ray ray_over_edge(Random& random) const {
    const int post = random.integer(1, kPosts - 3);
    const double near = random.chance(0.5) ? random.uniform(0, 1) : random.log_uniform(1e-10, 1);
    const double share = random.chance(0.5) ? near : 1 - near;
    const double edge_m = post_m(post, 0) + share * (post_m(post + 1, 0) - post_m(post, 0));
    const double to_m = edge_m + random.sign() * random.log_uniform(1e-7, 10);
    const double away = random.log_uniform(1e-3, kPosts - 200) * (wall_ > kPosts / 2 ? -1 : 1);
    const bool level = away < -1 ? random.chance(0.3) : random.chance(0.6);
    const double from_m = level ? std::max(1.0, to_m - random.log_uniform(1e-8, 1e-2)) : 1;
    const glm::dvec3 from = place(wall_ + away, random.uniform(1, kPosts - 2), from_m);
    const glm::dvec3 to = place(wall_, post + share, to_m);
    return {.origin_m = from, .direction = glm::normalize(to - from)};
  }

 private:
  static constexpr int kPosts = 1500;
  static constexpr SurfaceModel kModel = SurfaceModel::hyperboloid;
  static VerticalFrame frame() { return {.eye_height_m = 500}; }

  static double post_m(int across, int behind) {
    return across < kPosts / 2 || (across * 7 + behind * 3) % 5 < 3 ? 3000 : 0;
  }

  [[nodiscard]] TerrainLayer layer() const {
    const auto height_m = [&](int column, int row) {
      if (transposed_) std::swap(column, row);
      const int behind = column - wall_;
      return behind == 0 || behind == 1 ? post_m(row, behind) : 0.0;
    };
    return make_layer(make_grid(kPosts, kPosts, height_m),
                      {.eye_uv = {5, 5}, .spacing_m = {30, 30}});
  }

  [[nodiscard]] glm::dvec3 place(double along, double across, double height_m) const {
    const GroundMap& map = *terrain_.layers()[0].map;
    const glm::dvec2 uv = transposed_ ? glm::dvec2(across, along) : glm::dvec2(along, across);
    return {glm::inverse(*map.linear()) * (uv - map.to_grid({0, 0})),
            height_m - frame().eye_height_m};
  }

  int wall_;
  bool transposed_;
  Terrain terrain_;
};

TEST(Occluded, AnswersSoAtTheEdgeOfAFarWall) {
  Random random(11);
  for (const auto& [wall, transposed] : {std::pair(1400, false), std::pair(100, true)}) {
    const FarWall scene(wall, transposed);
    std::vector<Ray> rays(30000);
    for (Ray& ray : rays) ray = scene.ray_over_edge(random);
    Answers answers;
    expect_answers_of_single_rays(scene.terrain(), rays, answers);
    EXPECT_GT(answers.stopped, 4000);
    EXPECT_GT(answers.free, 4000);
  }
}

// A plain with holes, and rays that go under it through them, past posts.
TEST(Occluded, AnswersSoBesidePostsBetweenHoles) {
  constexpr int kPosts = 40;
  Random random(12);
  Answers answers;
  for (int i = 0; i < 50; ++i) {
    const auto height_m = [&](int, int) { return random.chance(0.4) ? std::nan("") : 100.0; };
    const Terrain terrain({make_layer(make_grid(kPosts, kPosts, height_m),
                                      {.eye_uv = {20, 20}, .spacing_m = {30, 30}})},
                          {.eye_height_m = 100}, SurfaceModel::hyperboloid);
    std::vector<Ray> rays;
    while (rays.size() < 3000) {
      const double away_m = random.log_uniform(1, 300);
      const double azimuth_rad = random.uniform(0, 6.3);
      const auto beside_m = [&] { return random.sign() * random.log_uniform(1e-9, 1e-3); };
      const glm::dvec3 to(30 * random.integer(-15, 15) + beside_m(),
                          30 * random.integer(-15, 15) + beside_m(), -random.log_uniform(0.01, 10));
      const glm::dvec3 from(to.x + away_m * std::sin(azimuth_rad),
                            to.y + away_m * std::cos(azimuth_rad), random.log_uniform(0.01, 10));
      if (!terrain.ground_at({from.x, from.y})) continue;
      rays.push_back({.origin_m = from, .direction = glm::normalize(to - from)});
    }
    expect_answers_of_single_rays(terrain, rays, answers);
  }
  EXPECT_GT(answers.stopped, 1000);
  EXPECT_GT(answers.free, 1000);
}

TEST(Occluded, AnswersSoUnderEveryInstructionSet) {
  const Terrain terrain = wide_hills(100, {.eye_height_m = 500,
                                           .north_curvature_per_m = kEarth_per_m,
                                           .east_curvature_per_m = kEarth_per_m,
                                           .refraction = 0.13});
  const std::vector<Ray> rays = sun_rays(terrain, 0.1);
  std::vector<TraceCounts> work;
  under_every_instruction_set([&] {
    Answers answers;
    expect_answers_of_single_rays(terrain, rays, answers);
    std::vector<std::uint8_t> stopped(rays.size());
    occluded(terrain, rays, stopped, work.emplace_back());
  });
  for (const TraceCounts& counts : work) {
    EXPECT_EQ(counts.tests, work[0].tests);
    EXPECT_EQ(counts.nodes, work[0].nodes);
  }
}

// What a ray may not decide in single precision costs the whole walk of the single ray.
TEST(Occluded, CostsLittleMoreWorkThanTheSingleRay) {
  const Terrain terrain = wide_hills(100, {.eye_height_m = 500});
  const std::vector<Ray> rays = sun_rays(terrain, 0.35);
  TraceCounts single;
  for (const Ray& ray : rays) static_cast<void>(terrain.occluded(ray, &single));
  TraceCounts counts;
  std::vector<std::uint8_t> stopped(rays.size());
  occluded(terrain, rays, stopped, counts);
  EXPECT_LT(counts.tests + counts.nodes, 1.2 * static_cast<double>(single.tests + single.nodes));
}

}  // namespace
}  // namespace terrview

// The bounds of terrain/eye_front.h against the ground itself.
#include "terrain/eye_front.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>
#include <glm/matrix.hpp>

#include "terrain/grid_walk.h"
#include "terrain/square_sectors.h"
#include "terrain/tracer.h"
#include "tests/support/judge.h"
#include "tests/support/random_scene.h"
#include "tests/support/scenes.h"

namespace terrview {
namespace {

// A front, all of whose wedges are made.
class WholeFront {
 public:
  WholeFront(const Terrain& terrain, const EyeFrontOptions& options)
      : front_(terrain, options), looks_at_lines_(options.looks_at_lines) {
    for (int group = 0; group < groups(); ++group) front_.make(group);
  }

  [[nodiscard]] const EyeFront& front() const { return front_; }
  [[nodiscard]] bool looks_at_lines() const { return looks_at_lines_; }
  [[nodiscard]] int groups() const { return 4 * front_.wedges_a_side() / EyeFront::kGroup; }

  [[nodiscard]] float bound(int wedge, int ring) const {
    return front_.bounds()[place(wedge, ring, front_.rings() + 1)];
  }
  [[nodiscard]] float coarse_bound(int wedge, int block) const {
    return front_.coarse_bounds()[place(wedge, block, front_.coarse_rings())];
  }
  [[nodiscard]] float bound_beyond(int wedge, int block) const {
    return front_.bounds_beyond()[place(wedge, block, front_.coarse_rings())];
  }

  [[nodiscard]] int wedge_of(glm::dvec2 direction) const {
    return sector_of(direction, front_.wedges_a_side());
  }

  // The ring in which a distance lies.
  [[nodiscard]] int ring_of(double distance_m) const {
    const auto rings_m = front_.ring_m();
    const auto next = std::upper_bound(rings_m.begin(), rings_m.end(), distance_m);
    return std::min(static_cast<int>(next - rings_m.begin()), front_.rings()) - 1;
  }

  // Where a ray may first meet the ground.
  [[nodiscard]] double start_m(glm::dvec2 direction, double slope) const {
    const double bin =
        (slope / (EyeFront::kHalfwaySlope + std::abs(slope)) + 1) * (EyeFront::kStartBins / 2);
    const int known = std::clamp(static_cast<int>(bin), front_.first_bin(), front_.last_bin());
    return front_.starts_m()[wedge_of(direction) * EyeFront::kStartBins + known];
  }

 private:
  [[nodiscard]] static std::size_t place(int wedge, int ring, int rings) {
    return static_cast<std::size_t>((wedge / EyeFront::kGroup * rings + ring) * EyeFront::kGroup +
                                    wedge % EyeFront::kGroup);
  }

  EyeFront front_;
  bool looks_at_lines_;
};

// Any camera: slopes from and to anywhere, or not known.
EyeFrontOptions random_options(Random& random) {
  EyeFrontOptions options;
  options.wedge_rad = random.log_uniform(0.003, 1);
  options.looks_at_lines = random.chance(0.8);
  if (random.chance(0.5)) {
    options.lowest_slope = random.uniform(-3, 0.5);
    options.highest_slope = options.lowest_slope + random.uniform(0, 2);
  }
  return options;
}

glm::dvec2 random_direction(Random& random) {
  const double azimuth_rad = random.uniform(0, 2 * std::numbers::pi);
  return {std::sin(azimuth_rad), std::cos(azimuth_rad)};
}

// The ground's slope at `z_m` in ring `ring` does not exceed the bound.
void expect_bounded(const WholeFront& whole, int wedge, int ring, double g_m, double z_m) {
  if (g_m == 0) return;
  EXPECT_LE(z_m / g_m, static_cast<double>(whole.bound(wedge, ring)))
      << "wedge " << wedge << ", ring " << ring << ", " << g_m << " m away";
}

// All the ground under a line from the eye, ring by ring: along a chord z / g is monotonic.
int expect_bounds_along(const WholeFront& whole, glm::dvec2 direction) {
  const Terrain& terrain = whole.front().terrain();
  const TerrainLayer& layer = terrain.layers()[0];
  const GroundLine line{{0, 0}, direction};
  const auto rings_m = whole.front().ring_m();
  const int wedge = whole.wedge_of(direction);
  GridWalk walk(*layer.grid, *layer.map, terrain.model(), line, 0, terrain.reach_m());
  const auto z_of = [&](const GridCrossing& crossing) {
    return terrain.frame()
        .at(line.at(crossing.g_m))
        .z_m(terrain.frame().z_scale * crossing.height_m);
  };
  int seen = 0;
  Span span;
  while (walk.over_grid() && walk.next(span)) {
    // In the eye's own cell rays begin at the eye, whatever the front says.
    if (!span.has_ground || span.in.g_m == 0 || span.out.g_m <= span.in.g_m) continue;
    ++seen;
    const double in_z_m = z_of(span.in);
    const double rise = (z_of(span.out) - in_z_m) / (span.out.g_m - span.in.g_m);
    const int last = whole.ring_of(span.out.g_m);
    for (int ring = whole.ring_of(span.in.g_m); ring <= last; ++ring) {
      const auto i = static_cast<std::size_t>(ring);
      for (const double g_m :
           {std::max(span.in.g_m, rings_m[i]), std::min(span.out.g_m, rings_m[i + 1])})
        expect_bounded(whole, wedge, ring, g_m, in_z_m + rise * (g_m - span.in.g_m));
    }
  }
  return seen;
}

template <class MakeTerrain, class Expect>
void for_each_front(std::uint64_t seed, const MakeTerrain& make, const Expect& expect) {
  Random random(seed);
  int served = 0;
  for (int i = 0; i < 300; ++i) {
    const Terrain terrain = make(random);
    if (!EyeFront::serves(terrain)) continue;
    ++served;
    expect(random, WholeFront(terrain, random_options(random)));
    ASSERT_FALSE(testing::Test::HasFailure()) << "seed " << seed << ", terrain " << i;
  }
  EXPECT_GT(served, 100);
}

Terrain straight(Random& random) {
  return random_terrain(random, SurfaceModel::hyperboloid,
                        random.chance(0.5) ? Position::general : Position::special);
}

Terrain bent(Random& random) { return random_parabolic_terrain(random, SurfaceModel::hyperboloid); }

void expect_ground_below(std::uint64_t seed, Terrain (*make)(Random&)) {
  int seen = 0;
  for_each_front(seed, make, [&](Random& random, const WholeFront& whole) {
    for (int i = 0; i < 30; ++i) seen += expect_bounds_along(whole, random_direction(random));
  });
  EXPECT_GT(seen, 10000);
}

TEST(EyeFront, BoundsTheGroundUnderLinesFromTheEye) { expect_ground_below(1, straight); }

TEST(EyeFront, BoundsItUnderBentTracks) { expect_ground_below(2, bent); }

// Of every cell that has ground: its posts, where a straight map shows them.
TEST(EyeFront, BoundsEveryPost) {
  int seen = 0;
  for_each_front(3, straight, [&](Random& /*random*/, const WholeFront& whole) {
    const Terrain& terrain = whole.front().terrain();
    const HeightGrid& grid = *terrain.layers()[0].grid;
    const GroundMap& map = *terrain.layers()[0].map;
    const glm::dmat2 to_ground = glm::inverse(*map.linear());
    const glm::dvec2 eye_uv = map.to_grid({0, 0});
    for (int row = 0; row < grid.rows; ++row)
      for (int column = 0; column < grid.columns; ++column) {
        const float height_m = grid.at(column, row);
        const glm::dvec2 at_m = to_ground * (glm::dvec2(column, row) - eye_uv);
        const double away_m = glm::length(at_m);
        if (std::isnan(height_m) || away_m == 0) continue;
        ++seen;
        const double z_m = terrain.frame().at(at_m).z_m(terrain.frame().z_scale * height_m);
        expect_bounded(whole, whole.wedge_of(at_m), whole.ring_of(away_m), away_m, z_m);
      }
  });
  EXPECT_GT(seen, 10000);
}

TEST(EyeFront, HasCoarseBoundsThatAreTheHighestOfTheFine) {
  for_each_front(4, straight, [](Random& random, const WholeFront& whole) {
    const EyeFront& front = whole.front();
    for (int i = 0; i < 20; ++i) {
      const int wedge = random.integer(0, 4 * front.wedges_a_side() - 1);
      float beyond = -std::numeric_limits<float>::infinity();
      for (int block = front.coarse_rings() - 1; block >= 0; --block) {
        float highest = -std::numeric_limits<float>::infinity();
        const int first = block * EyeFront::kStride;
        for (int ring = first; ring < std::min(first + EyeFront::kStride, front.rings()); ++ring)
          highest = std::max(highest, whole.bound(wedge, ring));
        beyond = std::max(beyond, highest);
        EXPECT_EQ(whole.bound_beyond(wedge, block), beyond);
        if (block + 1 < front.coarse_rings()) {
          EXPECT_EQ(whole.coarse_bound(wedge, block), highest);
        }
      }
    }
  });
}

// Where a ray leaves the cell of its hit.
double leaves_m(const Terrain& terrain, const Ray& ray, const Trace& found) {
  const TerrainLayer& layer = terrain.layers()[0];
  GridWalk walk(*layer.grid, *layer.map, terrain.model(), ground_line(ray), 0, terrain.reach_m());
  Span span;
  while (walk.over_grid() && walk.next(span))
    if (span.out.g_m >= found.ground_m) return span.out.g_m;
  return found.ground_m;
}

void expect_starts_before_hits(std::uint64_t seed, Terrain (*make)(Random&)) {
  int hits = 0;
  for_each_front(seed, make, [&](Random& random, const WholeFront& whole) {
    const Terrain& terrain = whole.front().terrain();
    for (int i = 0; i < 200; ++i) {
      const Ray ray{.direction = random_ray(random, terrain, Position::general).direction};
      if (is_vertical(ray)) continue;
      const Trace found = trace(terrain, terrain.ceiling_m(), ray);
      if (found.outcome != Outcome::hit) continue;
      ++hits;
      // From lines a ray begins in the cell of its hit, maybe beyond it.
      EXPECT_LE(whole.start_m(ground_line(ray).direction, ray_slope(ray)),
                whole.looks_at_lines() ? leaves_m(terrain, ray, found) : found.ground_m)
          << oracle::to_string(ray);
    }
  });
  EXPECT_GT(hits, 3000);
}

TEST(EyeFront, StartsRaysBeforeTheirHits) { expect_starts_before_hits(5, straight); }

TEST(EyeFront, StartsThemBeforeTheirHitsOnBentTracks) { expect_starts_before_hits(6, bent); }

// A ray that is just below the ground where it crosses a line starts before.
int expect_starts_before_crossings(const WholeFront& whole, glm::dvec2 direction) {
  const Terrain& terrain = whole.front().terrain();
  const TerrainLayer& layer = terrain.layers()[0];
  const GroundLine line{{0, 0}, direction};
  GridWalk walk(*layer.grid, *layer.map, terrain.model(), line, 0, terrain.reach_m());
  int seen = 0;
  Span span;
  while (walk.over_grid() && walk.next(span)) {
    const double g_m = span.out.g_m;
    if (!span.has_ground || g_m == 0) continue;
    ++seen;
    const double height_m = terrain.frame().z_scale * span.out.height_m;
    const double slope = terrain.frame().at(line.at(g_m)).z_m(height_m) / g_m;
    EXPECT_LE(whole.start_m(direction, slope), g_m) << direction.x << ", " << direction.y;
  }
  return seen;
}

void expect_starts_before_crossings(std::uint64_t seed, Terrain (*make)(Random&)) {
  int seen = 0;
  for_each_front(seed, make, [&](Random& random, const WholeFront& whole) {
    for (int i = 0; i < 30; ++i)
      seen += expect_starts_before_crossings(whole, random_direction(random));
  });
  EXPECT_GT(seen, 10000);
}

// A plane, however turned, seen from above it: nothing hides what a start may be late for.
Terrain sloping(Random& random) {
  const glm::dvec2 climb(random.chance(0.5) ? 0 : random.uniform(-1, 1), random.uniform(-1, 1));
  const glm::dvec2 eye_uv(random.uniform(-5, 35), random.uniform(-5, 35));
  const HeightGrid grid = make_grid(31, 31, [&](int column, int row) {
    return glm::dot(climb, glm::dvec2(column, row) - eye_uv);
  });
  const double angle = random.uniform(0, 2 * std::numbers::pi);
  const glm::dmat2 turned(std::cos(angle), std::sin(angle), -std::sin(angle), std::cos(angle));
  const auto map = std::make_shared<const AffineGroundMap>(
      eye_uv, glm::dmat2(random.uniform(0.5, 2), 0, 0, 1) * turned, glm::ivec2(31, 31));
  return {{{.grid = std::make_shared<const HeightGrid>(grid), .map = map}},
          {.eye_height_m = random.log_uniform(0.1, 20)},
          SurfaceModel::hyperboloid};
}

TEST(EyeFront, StartsRaysBeforeEveryCrossing) { expect_starts_before_crossings(9, straight); }

TEST(EyeFront, StartsThemBeforeEveryCrossingOfBentTracks) {
  expect_starts_before_crossings(10, bent);
}

TEST(EyeFront, StartsThemBeforeEveryCrossingOfASlope) {
  expect_starts_before_crossings(11, sloping);
}

// 100 m above a plain no sector is seen more steeply than its far end.
TEST(EyeFront, IsTightOverAPlain) {
  const Terrain terrain =
      make_terrain(make_grid(101, 101, [](int, int) { return 400; }),
                   {.eye_uv = {50.3, 50.4}, .spacing_m = {30, 30}, .eye_height_m = 500},
                   SurfaceModel::hyperboloid);
  const WholeFront whole(terrain, {.wedge_rad = 0.01});
  const auto rings_m = whole.front().ring_m();
  for (int ring = 0; rings_m[static_cast<std::size_t>(ring) + 1] < 1400; ++ring)
    for (int wedge = 0; wedge < 4 * whole.front().wedges_a_side(); ++wedge)
      EXPECT_NEAR(whole.bound(wedge, ring) * rings_m[static_cast<std::size_t>(ring) + 1] / -100, 1,
                  1e-6);
}

// How many cells a ray looks at, from its start to that of its hit.
int cells_from_start(const WholeFront& whole, const Ray& ray, const Trace& found) {
  const Terrain& terrain = whole.front().terrain();
  const TerrainLayer& layer = terrain.layers()[0];
  const GroundLine line = ground_line(ray);
  const double start_m = whole.start_m(line.direction, ray_slope(ray));
  GridWalk walk(*layer.grid, *layer.map, terrain.model(), line, 0, terrain.reach_m());
  int cells = 0;
  Span span;
  while (walk.over_grid() && walk.next(span)) {
    cells += span.out.g_m > start_m ? 1 : 0;
    if (span.out.g_m >= found.ground_m) break;
  }
  return cells;
}

// Rough ground, 100 m below, in all directions, along the grid too.
TEST(EyeFront, StartsRaysNextToTheirHitsWhereCellsAreWiderThanWedges) {
  Random random(8);
  const Terrain terrain =
      make_terrain(make_grid(101, 101, [&](int, int) { return random.uniform(0, 10); }),
                   {.eye_uv = {50.3, 50.4}, .spacing_m = {30, 30}, .eye_height_m = 100},
                   SurfaceModel::hyperboloid);
  const WholeFront whole(terrain, {.wedge_rad = 0.004});
  int hits = 0;
  int cells = 0;
  for (int i = 0; i < 5000; ++i) {
    const glm::dvec2 across = random_direction(random);
    const Ray ray{.direction = {across.x, across.y, random.uniform(-0.7, -0.07)}};
    const Trace found = trace(terrain, terrain.ceiling_m(), ray);
    if (found.outcome != Outcome::hit) continue;
    ++hits;
    cells += cells_from_start(whole, ray, found);
  }
  EXPECT_GT(hits, 4900);
  EXPECT_LT(cells, 1.4 * hits);
}

TEST(EyeFront, KnowsTheRingOfEveryStep) {
  for_each_front(7, straight, [](Random& /*random*/, const WholeFront& whole) {
    const EyeFront& front = whole.front();
    const auto rings_m = front.ring_m();
    for (std::size_t ring = 1; ring < rings_m.size(); ++ring)
      EXPECT_GE(rings_m[ring] - rings_m[ring - 1], front.step_m());
    const auto rings = front.ring_at_step();
    EXPECT_GE(static_cast<double>(rings.size()) * front.step_m(), rings_m.back());
    for (std::size_t step = 0; step < rings.size(); ++step)
      EXPECT_EQ(rings[step], whole.ring_of(static_cast<double>(step) * front.step_m()));
  });
}

}  // namespace
}  // namespace terrview

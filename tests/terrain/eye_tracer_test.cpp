#include "terrain/eye_tracer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "terrain/eye_tracks.h"
#include "tests/support/eye_rays.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/parabolic_map.h"
#include "tests/support/random_scene.h"
#include "tests/support/sanitized.h"
#include "tests/support/scenes.h"

namespace terrview {
namespace {

// Directions all around; in bundles near to each other, as those of an image are; and vertical.
std::vector<glm::dvec3> random_directions(Random& random, const Terrain& terrain,
                                          Position position) {
  std::vector<glm::dvec3> directions;
  while (directions.size() < 200) {
    const glm::dvec3 direction = random_ray(random, terrain, position).direction;
    directions.push_back(direction);
    const double spread = glm::length(direction) * random.log_uniform(1e-9, 0.1);
    for (int i = random.integer(0, 30); i > 0; --i) {
      const glm::dvec3 shift(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
      directions.push_back(direction + spread * shift);
    }
    if (random.chance(0.1)) directions.emplace_back(0, 0, random.sign());
  }
  return directions;
}

template <class MakeTerrain>
void expect_same_bits(std::uint64_t seed, Position position, const MakeTerrain& make) {
  constexpr int kScenes = fewer_if_sanitized(300);
  Random random(seed);
  int met = 0;
  for (int i = 0; i < kScenes; ++i) {
    const Terrain terrain = make(random);
    if (!EyeFront::serves(terrain)) continue;
    EyeFrontOptions options;
    options.wedge_rad = random.log_uniform(1e-3, 1);
    if (random.chance(0.5)) {
      options.lowest_slope = random.uniform(-2, 0.5);
      options.highest_slope = options.lowest_slope + random.uniform(0, 2);
    }
    const EyeFront front(terrain, options);
    met += expect_hits_of_single_rays(front, random_directions(random, terrain, position));
    ASSERT_FALSE(testing::Test::HasFailure()) << "seed " << seed << ", terrain " << i;
  }
  EXPECT_GT(met, 16 * kScenes);
}

TEST(TraceEyeRays, HasTheHitsOfSingleRaysBitForBit) {
  expect_same_bits(1, Position::general, [](Random& random) {
    return random_terrain(random, SurfaceModel::hyperboloid, Position::general);
  });
}

TEST(TraceEyeRays, HasThemThroughPostsAndAlongLines) {
  expect_same_bits(2, Position::special, [](Random& random) {
    return random_terrain(random, SurfaceModel::hyperboloid, Position::special);
  });
}

TEST(TraceEyeRays, HasThemOnBentTracks) {
  expect_same_bits(3, Position::general, [](Random& random) {
    return random_parabolic_terrain(random, SurfaceModel::hyperboloid);
  });
}

// A wall that is met by tracks which have been off the grid in between.
TEST(TraceEyeRays, HasThemOnTracksThatLeaveTheGridAndComeBack) {
  const auto map = std::make_shared<const ParabolicGroundMap>(glm::dvec2(2, 3), 1.0, 1e-3, 170.0);
  Random ground(7);
  const HeightGrid wall =
      make_grid(40, 150, [&](int, int row) { return row < 110 ? ground.uniform(0, 9) : 50; });
  const Terrain terrain({{.grid = std::make_shared<const HeightGrid>(wall), .map = map}},
                        {.eye_height_m = 10}, SurfaceModel::hyperboloid);
  ASSERT_TRUE(EyeFront::serves(terrain));
  Random random(6);
  std::vector<glm::dvec3> directions;
  int returned = 0;
  while (directions.size() < 2000) {
    const double azimuth_rad = random.uniform(-0.16, 0);
    const glm::dvec2 across(std::sin(azimuth_rad), std::cos(azimuth_rad));
    directions.emplace_back(across, random.uniform(-0.06, 0.02));
    returned += map->to_grid(50.0 * across).x < 0 && map->to_grid(120.0 * across).x > 0 ? 1 : 0;
  }
  EXPECT_GT(returned, 200);
  const EyeFront front(terrain, {.wedge_rad = 0.01});
  EXPECT_GT(expect_hits_of_single_rays(front, directions), 500);
}

// A wall one cell thin, that tracks leave the grid to come back to.
TEST(TraceEyeRays, HasThemOnAWallThatIsMetFromOutside) {
  Random random(10);
  int met = 0;
  for (int i = 0; i < 60; ++i) {
    const int wall = random.integer(1, 10);
    const HeightGrid grid = make_grid(
        40, 150, [&](int column, int) { return column == wall ? 100 : random.uniform(0, 1); });
    const glm::dvec2 eye_uv(random.uniform(-20, 1), random.uniform(0, 20));
    const auto map = std::make_shared<const ParabolicGroundMap>(
        eye_uv, 1.0, random.uniform(0.001, 0.006), 150.0);
    const Terrain terrain({{.grid = std::make_shared<const HeightGrid>(grid), .map = map}},
                          {.eye_height_m = random.uniform(20, 150)}, SurfaceModel::hyperboloid);
    if (!EyeFront::serves(terrain)) continue;
    std::vector<glm::dvec3> directions;
    for (int j = 0; j < 100; ++j) {
      const double azimuth_rad = random.uniform(-0.3, 0.3);
      const double slope = random.uniform(-0.7, 0.7);
      directions.emplace_back(std::sin(azimuth_rad), std::cos(azimuth_rad), slope);
    }
    met += expect_hits_of_single_rays(EyeFront(terrain, {.wedge_rad = 0.004}), directions);
  }
  EXPECT_GT(met, 500);
}

// The eye stands beside a row by the least there is, and the row's tracks begin their next pieces
// on it: a leap that settles in a cell on the other side must come to an end all the same.
TEST(TraceEyeRays, HasThemAlongALineThatRoundingPutsOnBothSides) {
  const double beside = std::nextafter(20.0, 21.0);
  Random random(0);
  for (int i = 0; i < 20; ++i) {
    const double bend_per_m = random.sign() * random.uniform(1e-5, 1e-3);
    const auto map =
        std::make_shared<const ParabolicGroundMap>(glm::dvec2(21, beside), 1.0, bend_per_m, 142.5);
    const Terrain terrain({{.grid = std::make_shared<const HeightGrid>(
                                make_grid(29, 28, [&](int, int) { return random.uniform(0, 1); })),
                            .map = map}},
                          {.eye_height_m = 20}, SurfaceModel::hyperboloid);
    std::vector<glm::dvec3> directions;
    for (int away = 2; away <= 18; ++away) directions.emplace_back(-away, 20 - beside, -20.5);
    expect_hits_of_single_rays(EyeFront(terrain, {}), directions);
  }
}

// Close by a column and a row, over a level plain on a small Earth: rays leave the ground, or do
// not, in the first crossing.
TEST(TraceEyeRays, HasThemOfAnEyeOnTheGround) {
  Random random(9);
  for (int i = 0; i < 200; ++i) {
    const glm::dvec2 eye_uv(16 - random.log_uniform(1e-13, 0.1),
                            14 - random.log_uniform(1e-13, 0.1));
    const auto map = std::make_shared<const AffineGroundMap>(
        eye_uv, glm::dmat2(1 / 30.0, 0, 0, -1 / 45.0), glm::ivec2(21, 32));
    VerticalFrame frame;
    frame.north_curvature_per_m = frame.east_curvature_per_m = 1e-4;
    const Terrain terrain(
        {{.grid = std::make_shared<const HeightGrid>(make_grid(21, 32, [](int, int) { return 0; })),
          .map = map}},
        frame, SurfaceModel::hyperboloid);
    std::vector<glm::dvec3> directions;
    for (int j = 0; j < 50; ++j) {
      const double azimuth_rad = random.uniform(0, 6.28);
      directions.emplace_back(std::sin(azimuth_rad), std::cos(azimuth_rad),
                              random.sign() * random.log_uniform(1e-7, 1e-2));
    }
    expect_hits_of_single_rays(EyeFront(terrain, {}), directions);
  }
}

// An azimuth between two, to its last bit, at which a coordinate of the track's knot passes a whole
// number; nullopt where there is none, or the knot is off the grid.
std::optional<double> knot_on_a_line(const EyeTracks& tracks, std::size_t knot, int axis,
                                     double from_rad, double to_rad, int posts) {
  const auto cell = [&](double azimuth_rad) {
    const glm::dvec2 direction(std::sin(azimuth_rad), std::cos(azimuth_rad));
    const std::vector<double>& knots_m = tracks.knots_m();
    return glm::floor(tracks.piece(direction, knots_m[knot - 1], knots_m[knot]).end);
  };
  const glm::dvec2 first = cell(from_rad);
  if (cell(to_rad)[axis] == first[axis]) return std::nullopt;
  if (glm::any(glm::lessThan(first, glm::dvec2(2))) ||
      glm::any(glm::greaterThan(first, glm::dvec2(posts - 4))))
    return std::nullopt;
  while (true) {
    const double middle_rad = (from_rad + to_rad) / 2;
    if (middle_rad == from_rad || middle_rad == to_rad) return from_rad;
    (cell(middle_rad)[axis] == first[axis] ? from_rad : to_rad) = middle_rad;
  }
}

// There rounding decides on which piece of its track a ray leaves a cell. Floats do not serve the
// wide grid.
TEST(TraceEyeRays, HasThemWhereKnotsLieOnLinesOfPosts) {
  constexpr int kPosts = 80;
  constexpr double kEye_m = 100;
  const auto map =
      std::make_shared<const ParabolicGroundMap>(glm::dvec2(40.3, 41.7), 30.0, 1e-5, 3000.0);
  const EyeTracks& tracks = *map->eye_tracks();
  Random random(9);
  std::vector<glm::dvec3> directions;
  while (directions.size() < 20000) {
    const auto knot = static_cast<std::size_t>(random.integer(1, tracks.pieces() - 1));
    const double azimuth_rad = random.uniform(-3, 3);
    const auto found =
        knot_on_a_line(tracks, knot, random.integer(0, 1), azimuth_rad, azimuth_rad + 0.03, kPosts);
    if (!found) continue;
    for (int i = -4; i <= 4; ++i) {
      const double near_rad = *found + i * 0x1p-52;
      const double ground_m = tracks.knots_m()[knot] + random.uniform(-15, 15);
      directions.emplace_back(std::sin(near_rad), std::cos(near_rad), -kEye_m / ground_m);
    }
  }
  for (const int columns : {kPosts, 1 << 15}) {
    const auto ground = std::make_shared<const HeightGrid>(
        make_grid(columns, kPosts, [&](int, int) { return random.uniform(0, 1); }));
    const Terrain terrain({{.grid = ground, .map = map}}, {.eye_height_m = kEye_m},
                          SurfaceModel::hyperboloid);
    ASSERT_TRUE(EyeFront::serves(terrain));
    const EyeFront front(terrain, {.wedge_rad = 0.01});
    under_every_instruction_set(
        [&] { EXPECT_GT(expect_hits_of_single_rays(front, directions), 15000); });
  }
}

// They come into the first cell along one piece of their track and meet its ground along the next.
TEST(TraceEyeRays, HasThemWhereKnotsLieInCellsOfTheBorder) {
  const auto map =
      std::make_shared<const ParabolicGroundMap>(glm::dvec2(-14.3, 41.7), 30.0, 1e-5, 3000.0);
  Random random(10);
  const Terrain terrain({{.grid = std::make_shared<const HeightGrid>(
                              make_grid(80, 80, [&](int, int) { return random.uniform(0, 1); })),
                          .map = map}},
                        {.eye_height_m = 100}, SurfaceModel::hyperboloid);
  std::vector<glm::dvec3> directions;
  int at_knot = 0;
  while (directions.size() < 5000) {
    const glm::dvec2 ground_m =
        ground_at(*map, {random.uniform(0, 1), 41.7 + random.uniform(-30, 30)});
    directions.emplace_back(ground_m, -100);
    const double g_m = glm::length(ground_m);
    const TrackPiece piece = map->eye_tracks()->piece(ground_m / g_m, g_m, 3000);
    at_knot += piece.begin_m > 0 && piece.start.x > 0 && piece.start.x < 1 ? 1 : 0;
  }
  EXPECT_GT(at_knot, 100);
  const EyeFront front(terrain, {.wedge_rad = 0.01});
  EXPECT_GT(expect_hits_of_single_rays(front, directions), 4000);
}

TEST(TraceEyeRays, HasThemUnderEveryInstructionSet) {
  under_every_instruction_set([] {
    expect_same_bits(5, Position::general, [](Random& random) {
      return random_terrain(random, SurfaceModel::hyperboloid, Position::general);
    });
    expect_same_bits(8, Position::general, [](Random& random) {
      return random_parabolic_terrain(random, SurfaceModel::hyperboloid);
    });
  });
}

// A picture's worth of rays over natural ground looks at few cells.
TEST(TraceEyeRays, LooksAtFewCells) {
  const Terrain terrain = make_terrain(
      make_grid(200, 200, [](int c, int r) { return 50 * std::sin(c * 0.3 + r * 0.2); }),
      {.eye_uv = {100.3, 100.4}, .spacing_m = {30, 30}, .eye_height_m = 200},
      SurfaceModel::hyperboloid);
  const EyeFront front(terrain, {.wedge_rad = 0.002});
  const auto rays = std::make_unique<EyeRays>();
  TraceCounts counts;
  for (int row = 0; row < 100; ++row) {
    rays->count = 100;
    for (int i = 0; i < 100; ++i) {
      const auto j = static_cast<std::size_t>(i);
      rays->direction_x[j] = 0.008 * (i - 50);
      rays->direction_y[j] = 1;
      rays->direction_z[j] = -0.002 * (row + 1);
    }
    trace(front, *rays, counts);
  }
  EXPECT_LE(counts.tests, 3 * 100 * 100);
}

}  // namespace
}  // namespace terrview

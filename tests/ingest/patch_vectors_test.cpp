// What maps tell of many points and lines at once is what they tell of one.
#include "ingest/patch_vectors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <vector>

#include "ingest/curved_ground_map.h"
#include "tests/ingest/ground_maps.h"
#include "tests/support/instruction_sets.h"

namespace terrview {
namespace {

class PatchVectors : public GroundMaps {};

struct ManyPoints {
  std::vector<double> x_m, y_m;

  void put(glm::dvec2 point) {
    x_m.push_back(point.x);
    y_m.push_back(point.y);
  }
};

// All over the disc, beyond it, and in one vector on both sides of a seam.
ManyPoints many_points(const GroundMap& map, const std::vector<glm::dvec2>& ground_of_posts) {
  ManyPoints points;
  for (const glm::dvec2 point : ground_of_posts) points.put(point);
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> share(-3, 3);
  for (int i = 0; i < 500; ++i) {
    const double x = share(random);
    points.put(map.reach_m() * glm::dvec2(x, share(random)));
  }
  if (const auto* curved = dynamic_cast<const CurvedGroundMap*>(&map))
    for (const PatchTree::Leaf& leaf : curved->patches().leaves())
      for (const glm::dvec2 corner : {leaf.low_m, leaf.high_m})
        for (const double side : {-1e-3, 0.0, 1e-3})
          if (std::isfinite(corner.x + corner.y)) points.put(corner + side);
  return points;
}

TEST_P(PatchVectors, TellManySlopesAsTheyTellOne) {
  const ManyPoints points = many_points(map(), ground_of_posts(1001));
  const std::size_t count = points.x_m.size();
  std::vector<double> values[4];
  for (std::vector<double>& each : values) each.resize(count);
  under_every_instruction_set([&] {
    for (std::vector<double>& each : values) std::fill(each.begin(), each.end(), std::nan(""));
    map().jacobians({points.x_m, points.y_m}, {values[0], values[1], values[2], values[3]});
    for (std::size_t i = 0; i < count; ++i)
      ASSERT_EQ(glm::dmat2(values[0][i], values[1][i], values[2][i], values[3][i]),
                map().jacobian({points.x_m[i], points.y_m[i]}))
          << points.x_m[i] << ", " << points.y_m[i];
  });
}

TEST_P(PatchVectors, TellManyPlacesAsTheyTellOne) {
  const ManyPoints points = many_points(map(), ground_of_posts(1001));
  const std::size_t count = points.x_m.size();
  std::vector<double> u(count);
  std::vector<double> v(count);
  under_every_instruction_set([&] {
    std::fill(u.begin(), u.end(), std::nan(""));
    std::fill(v.begin(), v.end(), std::nan(""));
    map().places({points.x_m, points.y_m}, {u, v});
    for (std::size_t i = 0; i < count; ++i)
      ASSERT_EQ(glm::dvec2(u[i], v[i]), map().to_grid({points.x_m[i], points.y_m[i]}))
          << points.x_m[i] << ", " << points.y_m[i];
  });
}

// Also along the axes, from the eye, from far along a line, and to nearby ends.
TEST_P(PatchVectors, EndManyPiecesAsTheyEndOne) {
  const ManyPoints points = many_points(map(), ground_of_posts(1001));
  const std::size_t count = points.x_m.size();
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> share(0, 1);
  std::uniform_int_distribution<int> kind(0, 7);
  ManyPoints origins;
  ManyPoints directions;
  std::vector<double> from_m;
  std::vector<double> limit_m;
  for (std::size_t i = 0; i < count; ++i) {
    const bool is_eyes = kind(random) == 0;
    origins.put(is_eyes ? glm::dvec2(0) : glm::dvec2(points.x_m[i], points.y_m[i]));
    const double azimuth = 2 * std::numbers::pi * share(random);
    const int axis = kind(random);
    directions.put(axis == 0   ? glm::dvec2(1, 0)
                   : axis == 1 ? glm::dvec2(0, -1)
                               : glm::dvec2(std::sin(azimuth), std::cos(azimuth)));
    from_m.push_back(kind(random) < 4 ? 0 : map().reach_m() * share(random));
    const double shares[] = {3, 3, 3, 1e-3, 1e-3, 1e-4, 1e-5, 1e-13};
    limit_m.push_back(from_m.back() +
                      map().reach_m() * shares[static_cast<std::size_t>(kind(random))]);
  }
  std::vector<double> ends_m(count);
  under_every_instruction_set([&] {
    std::fill(ends_m.begin(), ends_m.end(), std::nan(""));
    map().piece_ends_m({origins.x_m, origins.y_m, directions.x_m, directions.y_m},
                       {from_m, limit_m}, ends_m);
    for (std::size_t i = 0; i < count; ++i)
      ASSERT_EQ(ends_m[i], map().piece_end_m({{origins.x_m[i], origins.y_m[i]},
                                              {directions.x_m[i], directions.y_m[i]}},
                                             from_m[i], limit_m[i]))
          << i;
  });
}

// Few are left to the map that ends one at a time.
TEST_P(PatchVectors, EndMostPiecesInVectors) {
  const auto* curved = dynamic_cast<const CurvedGroundMap*>(&map());
  if (!curved) return;
  ManyPoints origins;
  ManyPoints directions;
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> turn(0, 2 * std::numbers::pi);
  for (const glm::dvec2 point : ground_of_posts(32)) {
    origins.put(point);
    const double azimuth = turn(random);
    directions.put({std::sin(azimuth), std::cos(azimuth)});
  }
  const std::size_t count = origins.x_m.size();
  const std::vector<double> from_m(count, 0);
  const std::vector<double> limit_m(count, map().reach_m());
  std::vector<double> ends_m(count);
  const GroundDisc disc{{0, 0}, 1e9};
  patch_piece_ends(curved->patches(), disc, {GroundMap::kTrackError_cells / 2, 1e-3, 1e-9},
                   {origins.x_m, origins.y_m, directions.x_m, directions.y_m}, {from_m, limit_m},
                   ends_m);
  const auto known =
      std::count_if(ends_m.begin(), ends_m.end(), [](double end_m) { return !std::isnan(end_m); });
  // The German map is as uneven as the grid that it is shifted by, and its patches are small.
  EXPECT_GT(known, GetParam().name == "German" ? 0 : static_cast<std::ptrdiff_t>(count / 2));
}

INSTANTIATE_TEST_SUITE_P(EveryKind, PatchVectors, testing::ValuesIn(cases::grid_cases()),
                         name_of_case);

}  // namespace
}  // namespace terrview

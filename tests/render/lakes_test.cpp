// Lakes on a grid: render/lakes.h.
#include "render/lakes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

namespace terrview {
namespace {

constexpr glm::ivec2 kGrid{21, 15};

// A star of random spikes with a star-shaped hole, some of it beside the grid.
Polygon random_lake(std::mt19937_64& random) {
  std::uniform_real_distribution<double> share(0, 1);
  const glm::dvec2 middle(share(random) * 24 - 2, share(random) * 18 - 2);
  std::vector<Polygon::Ring> rings(2);
  const double size = 1 + 8 * share(random);
  for (int ring = 0; ring < 2; ++ring)
    for (int i = 0; i < 23; ++i) {
      const double turn = i * 2 * 3.141592653589793 / 23;
      const double reach = size * (ring == 0 ? 0.5 + 0.5 * share(random) : 0.3 * share(random));
      rings[static_cast<std::size_t>(ring)].push_back(
          middle + reach * glm::dvec2(std::cos(turn), std::sin(turn)));
    }
  return Polygon(rings);
}

glm::ivec2 cell_of(glm::dvec2 uv) {
  return {std::min(static_cast<int>(uv.x), kGrid.x - 2),
          std::min(static_cast<int>(uv.y), kGrid.y - 2)};
}

TEST(Lakes, ContainThePointsOfTheirOutlinesAndNoOthers) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> share(0, 1);
  int wet = 0;
  for (int round = 0; round < 60; ++round) {
    const std::vector<Polygon> outlines{random_lake(random), random_lake(random),
                                        random_lake(random)};
    const Lakes lakes(outlines, kGrid);
    for (int i = 0; i < 500; ++i) {
      const glm::dvec2 uv(share(random) * (kGrid.x - 1), share(random) * (kGrid.y - 1));
      const bool expected = std::any_of(outlines.begin(), outlines.end(),
                                        [&](const Polygon& p) { return p.contains(uv); });
      ASSERT_EQ(lakes.contain(cell_of(uv), uv), expected) << uv.x << ' ' << uv.y;
      wet += expected ? 1 : 0;
    }
  }
  EXPECT_GT(wet, 3000);
}

// Whether a part of the line from `a` to `b` lies in the cell, by clipping it.
bool enters(glm::dvec2 a, glm::dvec2 b, glm::dvec2 cell) {
  double from = 0;
  double to = 1;
  for (int axis = 0; axis < 2; ++axis) {
    const double step = b[axis] - a[axis];
    const double low = (cell[axis] - a[axis]) / step;
    const double high = (cell[axis] + 1 - a[axis]) / step;
    from = std::max(from, std::min(low, high));
    to = std::min(to, std::max(low, high));
  }
  return from <= to;
}

bool touches(const Polygon& lake, glm::dvec2 cell) {
  if (lake.contains(cell + 0.5)) return true;
  const auto corners = lake.vertices();
  for (std::size_t i = 0; i + 1 < corners.size(); ++i)
    if (lake.is_edge(i) && enters(corners[i], corners[i + 1], cell)) return true;
  return false;
}

TEST(CellsOfAPolygon, AreThoseThatItTouches) {
  std::mt19937_64 random(11);
  int touched = 0;
  for (int round = 0; round < 200; ++round) {
    const Polygon lake = random_lake(random);
    std::set<std::pair<int, int>> cells;
    for_each_cell_of(lake, kGrid, [&](glm::ivec2 cell) { cells.insert({cell.x, cell.y}); });
    std::set<std::pair<int, int>> expected;
    for (int row = 0; row < kGrid.y - 1; ++row)
      for (int column = 0; column < kGrid.x - 1; ++column)
        if (touches(lake, {column, row})) expected.insert({column, row});
    ASSERT_EQ(cells, expected) << round;
    touched += static_cast<int>(cells.size());
  }
  EXPECT_GT(touched, 2000);
}

TEST(CellsOfAPolygon, BesideTheGridAreNone) {
  const std::vector<Polygon::Ring> rings{{{-9e8, -5}, {-3, -5}, {-3, 9e8}}};
  int cells = 0;
  for_each_cell_of(Polygon(rings), kGrid, [&](glm::ivec2) { ++cells; });
  EXPECT_EQ(cells, 0);
}

}  // namespace
}  // namespace terrview

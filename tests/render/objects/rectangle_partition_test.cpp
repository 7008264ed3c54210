// Promises of rectangle_partition.h, rectangle_tiles.h and rank_set.h, cell by cell.
#include "render/objects/rectangle_partition.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <vector>

#include "render/objects/rank_set.h"
#include "render/objects/rectangle_tiles.h"
#include "tests/render/objects/random_objects.h"

namespace terrview {
namespace {

struct Plane {
  RankedAxis x;
  RankedAxis y;
  Partition partition;
};

std::vector<Range> ranges(const Objects& objects, int axis) {
  std::vector<Range> ranges;
  for (const auto& object : objects) {
    const Box box = object->bounds();
    ranges.push_back(range_around(box.lowest_m[axis], box.highest_m[axis]));
  }
  return ranges;
}

Plane plane_of(const Objects& objects) {
  RankedAxis x = rank_axis(ranges(objects, 0));
  RankedAxis y = rank_axis(ranges(objects, 1));
  Partition partition = *cut_plane(x, y, 1000000);
  return {std::move(x), std::move(y), std::move(partition)};
}

std::vector<Plane> planes() {
  std::vector<Plane> planes;
  for (int seed = 0; seed < 300; ++seed) {
    RandomObjects random(static_cast<std::uint64_t>(seed));
    planes.push_back(plane_of(seed % 2 == 0 ? random.on_lattice(1 + seed % 17, 1 + seed % 9)
                                            : random.scattered(1 + seed % 17, 1 + seed)));
  }
  return planes;
}

bool holds(const Interval& interval, int column) {
  return interval.low <= column && column < interval.high;
}

TEST(Partition, EachColumnAndRowIsOfOneRectangleWithTheListOfItsObjects) {
  for (const Plane& plane : planes())
    for (int column = 0; column < plane.x.lines.borders() - 1; ++column)
      for (int row = 0; row < plane.y.lines.borders() - 1; ++row) {
        std::vector<int> objects;
        for (std::size_t i = 0; i < plane.x.intervals.size(); ++i)
          if (holds(plane.x.intervals[i], column) && holds(plane.y.intervals[i], row))
            objects.push_back(static_cast<int>(i));
        int found = 0;
        for (const Rectangle& it : plane.partition.rectangles) {
          if (!holds(it.x, column) || !holds(it.y, row)) continue;
          ++found;
          const bool is_empty = it.list == Rectangle::kEmpty;
          ASSERT_EQ(is_empty, objects.empty());
          if (is_empty) continue;
          ASSERT_TRUE(std::ranges::equal(plane.partition.lists[it.list], objects));
        }
        ASSERT_EQ(found, 1);
      }
}

// That those beyond a side at `border` follow each other along all of its interval.
void expect_neighbours(const Plane& plane, const Tiles& tiles, int beyond, int border,
                       const Interval& along, std::size_t side) {
  const bool is_x = side < 2;
  const Lines& lines = is_x ? plane.x.lines : plane.y.lines;
  if (border == (side % 2 == 0 ? 0 : lines.borders() - 1)) {
    EXPECT_EQ(beyond, Tile::kEdge);
    return;
  }
  ASSERT_NE(beyond, Tile::kEdge);
  const auto other = [&](std::size_t tile) {
    const Rectangle& it = plane.partition.rectangles[tile];
    const Interval& across = is_x ? it.x : it.y;
    EXPECT_EQ(side % 2 == 0 ? across.high : across.low, border);
    return is_x ? it.y : it.x;
  };
  if (beyond >= 0) {
    const Interval it = other(static_cast<std::size_t>(beyond));
    EXPECT_LE(it.low, along.low);
    EXPECT_GE(it.high, along.high);
    return;
  }
  const auto first = static_cast<std::size_t>(-2 - beyond);
  const Lines& across_lines = is_x ? plane.y.lines : plane.x.lines;
  int begin = along.low;
  for (std::size_t i = 1; i <= tiles.neighbours[first].tile; ++i) {
    const Neighbour& neighbour = tiles.neighbours[first + i];
    const Interval it = other(neighbour.tile);
    const int end = std::min(it.high, along.high);
    EXPECT_LE(it.low, begin);
    EXPECT_LT(begin, end);
    EXPECT_EQ(neighbour.end_m, across_lines.border_m(end));
    EXPECT_EQ(neighbour.is_behind, end % 2 == 0 ? 0U : 1U);
    begin = end;
  }
  EXPECT_EQ(begin, along.high);
}

// Each of n boxes apart from each other needs four edges, and each edge makes one rectangle.
TEST(Partition, BoxesApartFromEachOtherLeaveThreeEmptyRectanglesEachAtMost) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    RandomObjects random(seed);
    const Plane plane = plane_of(random.scattered(1000, 0.01));
    EXPECT_LE(plane.partition.rectangles.size(), 4 * plane.x.intervals.size() + 1);
  }
}

TEST(Partition, StopsAtTheGivenSize) {
  RandomObjects random(1);
  const Objects objects = random.scattered(100, 50);
  EXPECT_FALSE(cut_plane(rank_axis(ranges(objects, 0)), rank_axis(ranges(objects, 1)), 100));
}

TEST(Tiles, KnowTheirNeighboursAndWhereThoseEnd) {
  for (const Plane& plane : planes()) {
    const auto& rectangles = plane.partition.rectangles;
    const Tiles tiles = link(plane.partition, plane.x.lines, plane.y.lines);
    ASSERT_EQ(tiles.tiles.size(), rectangles.size());
    for (std::size_t i = 0; i < rectangles.size(); ++i) {
      const Rectangle& it = rectangles[i];
      expect_neighbours(plane, tiles, tiles.tiles[i].beyond[0], it.x.low, it.y, 0);
      expect_neighbours(plane, tiles, tiles.tiles[i].beyond[1], it.x.high, it.y, 1);
      expect_neighbours(plane, tiles, tiles.tiles[i].beyond[2], it.y.low, it.x, 2);
      expect_neighbours(plane, tiles, tiles.tiles[i].beyond[3], it.y.high, it.x, 3);
    }
  }
}

TEST(RankSet, FindsNeighboursAsAnOrderedSetDoes) {
  std::mt19937 engine(1);
  for (const int size : {1, 63, 64, 65, 4096, 4097, 300000}) {
    RankSet ranks(size);
    std::set<int> expected{0, size - 1};
    ranks.insert(0);
    ranks.insert(size - 1);
    std::uniform_int_distribution<int> any(0, size - 1);
    for (int i = 0; i < 3000; ++i) {
      const int at = any(engine);
      if (at != 0 && at != size - 1 && expected.erase(at) == 1) {
        ranks.erase(at);
      } else {
        expected.insert(at);
        ranks.insert(at);
      }
      const int from = any(engine);
      EXPECT_EQ(ranks.contains(from), expected.contains(from));
      EXPECT_EQ(ranks.next(from), *expected.lower_bound(from));
      EXPECT_EQ(ranks.previous(from), *std::prev(expected.upper_bound(from)));
    }
  }
}

}  // namespace
}  // namespace terrview

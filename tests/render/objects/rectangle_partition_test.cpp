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

Plane plane_of(const Objects& objects) {
  std::vector<Box> boxes;
  for (const auto& object : objects) boxes.push_back(object->bounds());
  RankedAxis x = rank_axis(boxes, 0);
  RankedAxis y = rank_axis(boxes, 1);
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
  std::vector<Box> boxes;
  for (const auto& object : random.scattered(100, 50)) boxes.push_back(object->bounds());
  EXPECT_FALSE(cut_plane(rank_axis(boxes, 0), rank_axis(boxes, 1), 100));
}

TEST(Tiles, KnowTheirNeighboursAndWhereThoseEnd) {
  for (const Plane& plane : planes()) {
    const Tiles tiles = link(plane.partition.rectangles);
    for (const Tile& tile : tiles.tiles)
      for (std::size_t side = 0; side < kSides; ++side) {
        const std::size_t along = 2 - side / 2 * 2;  // the lower of the sides that it ends at
        const std::size_t opposite = side ^ 1;
        int begin = tile.border[along];
        for (std::uint32_t i = 0; i < tile.count[side]; ++i) {
          const Neighbour& neighbour = tiles.neighbours[tile.first[side] + i];
          const Tile& other = tiles.tiles[static_cast<std::size_t>(neighbour.tile)];
          EXPECT_EQ(other.border[opposite], tile.border[side]);
          EXPECT_LE(other.border[along], begin);
          EXPECT_EQ(std::min(other.border[along + 1], tile.border[along + 1]), neighbour.end);
          EXPECT_LT(begin, neighbour.end);
          begin = neighbour.end;
        }
        const Lines& lines = side < 2 ? plane.x.lines : plane.y.lines;
        const bool is_edge = tile.border[side] == (side % 2 == 0 ? 0 : lines.borders() - 1);
        EXPECT_EQ(begin, is_edge ? tile.border[along] : tile.border[along + 1]);
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

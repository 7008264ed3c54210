#include "terrain/height_floors.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/support/random_scene.h"
#include "tests/support/scenes.h"

namespace terrview {
namespace {

TEST(HeightFloors, BoundThePostsOfEveryCellAndKnowItsHoles) {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const HeightGrid grid = random_grid(random);
    const HeightFloors floors(grid);
    for (int level = HeightFloors::kFirstLevel; level <= floors.last_level(); ++level) {
      for (int row = 0; row < grid.rows - 1; ++row) {
        for (int column = 0; column < grid.columns - 1; ++column) {
          const float lowest_m = floors.lowest_m(level, {column, row});
          if (!grid.has_ground(column, row)) {
            EXPECT_EQ(lowest_m, -std::numeric_limits<float>::infinity());
          }
          for (const glm::ivec2 post : {glm::ivec2(0, 0), {1, 0}, {0, 1}, {1, 1}})
            EXPECT_FALSE(grid.at(column + post.x, row + post.y) < lowest_m);
        }
      }
    }
  }
}

TEST(HeightFloors, EndWithOneBlockThatIsTheLowestPost) {
  for (const glm::ivec2 size : {glm::ivec2(2, 2), {9, 9}, {10, 9}, {2, 100}, {129, 40}}) {
    const HeightGrid grid =
        make_grid(size.x, size.y, [](int c, int r) { return c == 0 && r == 0 ? -5 : c + r; });
    const HeightFloors floors(grid);
    EXPECT_EQ(floors.lowest_m(floors.last_level(), {size.x - 2, size.y - 2}), -5);
  }
}

}  // namespace
}  // namespace terrview

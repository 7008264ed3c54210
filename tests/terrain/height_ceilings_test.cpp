#include "terrain/height_ceilings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <glm/vec2.hpp>

#include "tests/support/instruction_sets.h"
#include "tests/support/random_scene.h"
#include "tests/support/scenes.h"

namespace terrview {
namespace {

constexpr float kNone = -std::numeric_limits<float>::infinity();

// The highest post of the cells of a block, its borders included.
float highest_post(const HeightGrid& grid, int level, glm::ivec2 block) {
  float highest_m = kNone;
  for (int row = block.y << level; row <= std::min((block.y + 1) << level, grid.rows - 1); ++row)
    for (int column = block.x << level;
         column <= std::min((block.x + 1) << level, grid.columns - 1); ++column)
      if (grid.at(column, row) > highest_m) highest_m = grid.at(column, row);
  return highest_m;
}

int blocks_along(int posts, int level) {
  const int side = 1 << level;
  return (posts - 1 + side - 1) / side;
}

void expect_highest_posts(const HeightGrid& grid) {
  const HeightCeilings ceilings(grid);
  for (int level = 1; level <= ceilings.last_level(); ++level) {
    const HeightCeilings::Level& found = ceilings.level(level);
    ASSERT_EQ(found.columns, blocks_along(grid.columns, level));
    ASSERT_EQ(found.rows, blocks_along(grid.rows, level));
    for (int row = 0; row < found.rows; ++row)
      for (int column = 0; column < found.columns; ++column)
        ASSERT_EQ(found.highest_m[static_cast<std::size_t>(row * found.columns + column)],
                  highest_post(grid, level, {column, row}))
            << grid.columns << " x " << grid.rows << ", level " << level << ", block " << column
            << ' ' << row;
  }
}

TEST(HeightCeilings, AreTheHighestPostsOfTheirBlocks) {
  Random random(1);
  for (int i = 0; i < 200; ++i) expect_highest_posts(random_grid(random));
}

TEST(HeightCeilings, AreThatForSizesThatNoVectorDivides) {
  for (const int columns : {2, 3, 4, 17, 33, 34, 35, 66, 131})
    for (const int rows : {2, 3, 8, 9, 10})
      expect_highest_posts(make_grid(columns, rows, [](int c, int r) {
        return (c * 7 + r) % 11 == 0 ? std::nan("") : 300 * std::sin(c * 1.3 + r * r);
      }));
}

TEST(HeightCeilings, AreThatUnderEveryInstructionSet) {
  under_every_instruction_set([] {
    Random random(2);
    for (int i = 0; i < 50; ++i) expect_highest_posts(random_grid(random));
  });
}

TEST(HeightCeilings, EndInOneBlock) {
  for (const glm::ivec2 size : {glm::ivec2(2, 2), {3, 2}, {9, 9}, {10, 9}, {2, 100}, {129, 40}}) {
    const HeightCeilings ceilings(
        make_grid(size.x, size.y, [](int c, int r) { return -1000 + c + r; }));
    const HeightCeilings::Level& last = ceilings.level(ceilings.last_level());
    EXPECT_EQ(last.columns * last.rows, 1);
    EXPECT_EQ(last.highest_m[0], static_cast<float>(size.x + size.y - 1002));
  }
}

TEST(HeightCeilings, AreInfinitelyLowWhereNoPostHasAHeight) {
  const HeightCeilings ceilings(
      make_grid(9, 9, [](int c, int) { return c < 3 ? std::nan("") : 5; }));
  EXPECT_EQ(ceilings.level(1).highest_m[0], kNone);
  EXPECT_EQ(ceilings.level(1).highest_m[1], 5);  // its last posts are those of column 4
  EXPECT_EQ(ceilings.level(2).highest_m[0], 5);
}

TEST(HeightCeilings, TakeAThirdOfTheHeightsMemory) {
  const HeightGrid grid = make_grid(257, 257, [](int c, int r) { return c - r; });
  const auto heights = static_cast<double>(grid.heights_m.size() * sizeof(float));
  EXPECT_NEAR(static_cast<double>(HeightCeilings(grid).bytes()) / heights, 1.0 / 3, 0.01);
}

TEST(HeightCeilings, AreTheSameInAnyOrder) {
  const HeightGrid grid = make_grid(300, 211, [](int c, int r) { return 50 * std::sin(c * r); });
  const HeightCeilings ceilings(grid);
  const HeightCeilings backwards(grid, [](int count, const std::function<void(int)>& work) {
    for (int i = count; i-- > 0;) work(i);
  });
  for (int level = 1; level <= ceilings.last_level(); ++level)
    for (int row = 0; row < grid.rows - 1; row += 3)
      for (int column = 0; column < grid.columns - 1; column += 3)
        ASSERT_EQ(ceilings.highest_m(level, {column, row}),
                  backwards.highest_m(level, {column, row}));
}

}  // namespace
}  // namespace terrview

#include "terrain/height_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "tests/support/scenes.h"

namespace terrview {
namespace {

TEST(HeightGrid, StoresHeightsRowByRow) {
  const HeightGrid grid{3, 2, {1, 2, 3, 4, 5, 6}};
  EXPECT_EQ(grid.at(0, 0), 1);
  EXPECT_EQ(grid.at(2, 0), 3);
  EXPECT_EQ(grid.at(0, 1), 4);
  EXPECT_EQ(grid.at(2, 1), 6);
}

TEST(HeightGrid, ACellThatTouchesAVoidPostIsAHole) {
  for (int post = 0; post < 9; ++post) {
    HeightGrid grid{3, 3, {0, 0, 0, 0, 0, 0, 0, 0, 0}};
    grid.heights_m[static_cast<std::size_t>(post)] = kVoid;
    for (int row = 0; row < 2; ++row) {
      for (int column = 0; column < 2; ++column) {
        const int across = post % 3 - column;
        const int down = post / 3 - row;
        const bool touches = across >= 0 && across <= 1 && down >= 0 && down <= 1;
        EXPECT_EQ(grid.has_ground(column, row), !touches) << post << " " << column << " " << row;
      }
    }
  }
}

TEST(HeightGrid, CoversItsOutermostPostsAndNothingBeyond) {
  const HeightGrid grid = make_grid(4, 3, [](int, int) { return 0; });
  EXPECT_TRUE(grid.covers({0, 0}));
  EXPECT_TRUE(grid.covers({3, 2}));
  EXPECT_FALSE(grid.covers({3 + 1e-9, 1}));
  EXPECT_FALSE(grid.covers({1, 2 + 1e-9}));
  EXPECT_FALSE(grid.covers({-1e-9, 1}));
  EXPECT_FALSE(grid.covers({1, -1e-9}));
}

TEST(HeightRange, LeavesOutVoids) {
  const HeightRange range = height_range({2, 3, {kVoid, -7, 12.5F, kVoid, 3, -400}});
  EXPECT_EQ(range.lowest_m, -400);
  EXPECT_EQ(range.highest_m, 12.5F);
}

TEST(HeightRange, IsThatOfItsLastPostsToo) {
  for (int posts = 2; posts < 70; ++posts) {
    for (int k = 0; k < posts; ++k) {
      HeightGrid grid{posts, 1, std::vector<float>(static_cast<std::size_t>(posts), 5)};
      float& post = grid.heights_m[static_cast<std::size_t>(k)];
      post = 7;
      EXPECT_EQ(height_range(grid).highest_m, 7);
      EXPECT_FALSE(height_range(grid).has_holes);
      post = -3;
      EXPECT_EQ(height_range(grid).lowest_m, -3);
      post = kVoid;
      const HeightRange range = height_range(grid);
      EXPECT_TRUE(range.has_holes && range.lowest_m == 5 && range.highest_m == 5) << posts << k;
    }
  }
}

TEST(HeightRange, IsNotANumberWhereThereIsNoHeight) {
  const HeightRange range = height_range({2, 2, {kVoid, kVoid, kVoid, kVoid}});
  EXPECT_TRUE(std::isnan(range.lowest_m));
  EXPECT_TRUE(std::isnan(range.highest_m));
}

}  // namespace
}  // namespace terrview

// One test per promise in quantize/color_tree.h.
#include "quantize/color_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <string>

#include "tests/quantize/colors.h"

namespace terrview {
namespace {

// The triplets as digits, from the top bits down. Alphabetical order is the tree's pre-order.
std::string path_of(Rgb8 color) {
  std::string path;
  for (int bit = 7; bit >= 0; --bit) {
    const int r = color.r / (1 << bit) % 2;
    const int g = color.g / (1 << bit) % 2;
    const int b = color.b / (1 << bit) % 2;
    path += static_cast<char>('0' + 4 * r + 2 * g + b);
  }
  return path;
}

Rgb8 color_of(const std::string& path) {
  Rgb8 color(0);
  for (std::size_t i = 0; i < path.size(); ++i) {
    const int digit = path[i] - '0';
    const int step = 128 >> i;
    color += Rgb8(digit / 4 * step, digit / 2 % 2 * step, digit % 2 * step);
  }
  return color;
}

// The leaves that are left when all colours are known from the start: from the deepest level up,
// parents in pre-order take the place of their children until few enough are left.
std::set<std::string> swept_leaves(const std::vector<Rgb8>& colors, std::size_t max_colors) {
  std::set<std::string> leaves;
  for (const Rgb8 color : colors) leaves.insert(path_of(color));
  for (std::size_t level = 8; leaves.size() > max_colors; --level) {
    std::set<std::string> parents;
    for (const std::string& leaf : leaves)
      if (leaf.size() == level) parents.insert(leaf.substr(0, level - 1));
    for (const std::string& parent : parents) {
      if (leaves.size() <= max_colors) break;
      leaves.erase(leaves.lower_bound(parent), leaves.lower_bound(parent + "8"));
      leaves.insert(parent);
    }
  }
  return leaves;
}

double most_records(int p) { return std::pow(2, p) * (3 * 8 - p + 4) / 3; }

TEST(ColorTree, KeepsWithinItsBoundsForEveryNumberOfPlanes) {
  for (int p = 1; p <= 16; ++p) {
    const int max_colors = 1 << p;
    ColorTree tree(max_colors);
    const std::size_t count = p < 12 ? 20000 : 150000;
    std::size_t inserted = 0;
    for (const Rgb8 color : random_colors(count, static_cast<std::uint32_t>(p))) {
      tree.insert(color);
      ASSERT_LE(tree.leaf_count(), max_colors) << p;
      if (++inserted % 997 == 0) {
        ASSERT_LE(static_cast<double>(tree.record_count()), most_records(p)) << p;
      }
    }
    EXPECT_GT(tree.leaf_count(), p < 3 ? 0 : max_colors - 8) << p;
  }
}

TEST(ColorTree, HoldsTheBoundOfTheThesisForItsOwnTable) {
  EXPECT_EQ(std::ceil(most_records(12)), 21846);
  ColorTree tree(4096);
  // As many paths as possible that part in the first levels and run to the last.
  std::mt19937 random(7);
  for (std::uint32_t top = 0; top < 4096; ++top)
    tree.insert(color_of_triplets(top << 12 | static_cast<std::uint32_t>(random() & 4095U)));
  EXPECT_EQ(tree.leaf_count(), 4096);
  EXPECT_EQ(tree.record_count(), 8 + 64 + 512 + 5 * 4096);
  EXPECT_LE(static_cast<double>(tree.record_count()), most_records(12));
}

TEST(ColorTree, HasTheLeavesOfTheSweepOverAllColors) {
  std::vector<Rgb8> colors = random_colors(3000, 3);
  const std::vector<Rgb8> landscape = landscape_colors(80, 60);
  colors.insert(colors.end(), landscape.begin(), landscape.end());
  for (const int max_colors : {1, 2, 4, 5, 8, 16, 63, 64, 100, 256, 1000, 4096, 65536}) {
    SCOPED_TRACE(max_colors);
    ColorTree tree(max_colors);
    for (const Rgb8 color : colors) tree.insert(color);
    Palette expected;
    for (const std::string& leaf : swept_leaves(colors, static_cast<std::size_t>(max_colors)))
      expected.push_back(color_of(leaf));
    EXPECT_EQ(tree.number_leaves(), expected);
  }
}

TEST(ColorTree, IsTheSameWhateverTheOrderOfThePixels) {
  std::vector<Rgb8> colors = landscape_colors(120, 90);
  ColorTree tree(200);
  for (const Rgb8 color : colors) tree.insert(color);
  const Palette palette = tree.number_leaves();
  std::mt19937 random(5);
  for (int i = 0; i < 5; ++i) {
    std::shuffle(colors.begin(), colors.end(), random);
    ColorTree shuffled(200);
    for (const Rgb8 color : colors) shuffled.insert(color);
    EXPECT_EQ(shuffled.number_leaves(), palette);
  }
}

TEST(ColorTree, LosesOnlyTheLastBitsOfAColor) {
  const std::vector<Rgb8> colors = random_colors(5000, 9);
  for (const int max_colors : {8, 64, 700, 4096}) {
    ColorTree tree(max_colors);
    for (const Rgb8 color : colors) tree.insert(color);
    const Palette palette = tree.number_leaves();
    const std::set<std::string> leaves = swept_leaves(colors, static_cast<std::size_t>(max_colors));
    for (const Rgb8 color : colors) {
      const std::uint32_t address = tree.address(color);
      ASSERT_LT(address, palette.size());
      const std::string leaf = *std::next(leaves.begin(), static_cast<std::ptrdiff_t>(address));
      EXPECT_EQ(path_of(color).substr(0, leaf.size()), leaf);
      EXPECT_EQ(palette[address], color_of(leaf));
    }
  }
}

TEST(ColorTree, KeepsEveryColorOfAPictureThatHasFewEnough) {
  const std::vector<Rgb8> colors = random_colors(250, 11);
  ColorTree tree(256);
  for (int i = 0; i < 3; ++i)
    for (const Rgb8 color : colors) tree.insert(color);
  const Palette palette = tree.number_leaves();
  for (const Rgb8 color : colors) EXPECT_EQ(palette[tree.address(color)], color);
}

// The example of the thesis, figure 5-1, its three bits a component at the top of eight.
TEST(ColorTree, TruncatesALaterColorAsTheThesisDoes) {
  const auto color = [](int first, int second, int third) {
    return color_of_triplets(static_cast<std::uint32_t>(64 * first + 8 * second + third) << 15);
  };
  ColorTree tree(5);
  for (const auto& [a, b, c] :
       {std::array{5, 2, 1}, {5, 2, 3}, {1, 4, 6}, {1, 5, 7}, {2, 2, 3}, {1, 5, 4}})
    tree.insert(color(a, b, c));
  // Levels 8 to 4 went without a loss; at level 3 the leaf of 1 4 6 and then those of 1 5 went.
  EXPECT_EQ(tree.leaf_count(), 5);
  tree.insert(color(1, 5, 0));
  EXPECT_EQ(tree.leaf_count(), 5);
  EXPECT_EQ(tree.number_leaves(), (Palette{color(1, 4, 0), color(1, 5, 0), color(2, 2, 3),
                                           color(5, 2, 1), color(5, 2, 3)}));
}

}  // namespace
}  // namespace terrview

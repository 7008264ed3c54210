// One test per promise in quantize/pruned_tree.h, and those of the cells that it grows from.
#include "quantize/pruned_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <tuple>

#include "quantize/quantizer.h"
#include "tests/quantize/colors.h"

namespace terrview {
namespace {

constexpr DeletionOrder kOrders[] = {DeletionOrder::population, DeletionOrder::error};

std::size_t distinct(const std::vector<Rgb8>& colors) {
  std::set<std::array<int, 3>> set;
  for (const Rgb8 color : colors) set.insert({color.r, color.g, color.b});
  return set.size();
}

double squared_error(const std::vector<Rgb8>& colors, const Quantizer& quantizer) {
  double sum = 0;
  for (const Rgb8 color : colors) {
    const Rgb8 got = quantizer.palette[quantizer.find(color)];
    for (int i = 0; i < 3; ++i) sum += std::pow(color[i] - got[i], 2);
  }
  return sum;
}

TEST(PrunedTree, UsesEveryAddress) {
  const std::vector<Rgb8> colors = landscape_colors(150, 100);
  const std::size_t all = distinct(colors);
  ASSERT_GT(all, 1500U);
  const ColorCells cells = gather_cells(counts_of(colors));
  for (const DeletionOrder order : kOrders) {
    for (const int wanted : {1, 2, 3, 5, 7, 8, 13, 16, 100, 256, 1000, 65536}) {
      const PrunedTree tree(cells, wanted, order);
      EXPECT_EQ(tree.palette().size(), std::min(all, static_cast<std::size_t>(wanted))) << wanted;
      std::set<std::uint32_t> used;
      for (const Rgb8 color : colors) used.insert(tree.address(color));
      EXPECT_EQ(used.size(), tree.palette().size()) << wanted;
    }
  }
}

TEST(PrunedTree, HasTheMeansOfItsPixels) {
  const std::vector<Rgb8> colors = landscape_colors(150, 100);
  for (const DeletionOrder order : kOrders) {
    const PrunedTree tree(gather_cells(counts_of(colors)), 53, order);
    std::map<std::uint32_t, std::array<double, 4>> sums;
    for (const Rgb8 color : colors) {
      auto& sum = sums[tree.address(color)];
      for (int i = 0; i < 3; ++i) sum[static_cast<std::size_t>(i)] += color[i];
      sum[3] += 1;
    }
    for (const auto& [address, sum] : sums)
      for (int i = 0; i < 3; ++i)
        EXPECT_EQ(tree.palette()[address][i],
                  std::floor(sum[static_cast<std::size_t>(i)] / sum[3] + 0.5));
  }
}

TEST(PrunedTree, IsTheSameWhateverTheOrderOfThePixels) {
  std::vector<Rgb8> colors = landscape_colors(120, 90);
  for (const DeletionOrder order : kOrders) {
    const PrunedTree tree(gather_cells(counts_of(colors)), 100, order);
    std::mt19937 random(5);
    std::shuffle(colors.begin(), colors.end(), random);
    EXPECT_EQ(PrunedTree(gather_cells(counts_of(colors)), 100, order).palette(), tree.palette());
  }
}

TEST(PrunedTree, ByErrorDeletesWhatCostsLeast) {
  // Two families far apart: one of two colours that differ by 2, one of two that differ by 1.
  const std::vector<Rgb8> colors{{4, 0, 0}, {6, 0, 0}, {200, 0, 0}, {201, 0, 0}};
  const PrunedTree by_error(gather_cells(counts_of(colors)), 3, DeletionOrder::error);
  EXPECT_EQ(by_error.palette(), (Palette{{4, 0, 0}, {6, 0, 0}, {201, 0, 0}}));
  // By population the family of fewer pixels goes.
  std::vector<Rgb8> many = colors;
  many.insert(many.end(), 5, Rgb8(201, 0, 0));
  const PrunedTree by_population(gather_cells(counts_of(many)), 3, DeletionOrder::population);
  EXPECT_EQ(by_population.palette(), (Palette{{5, 0, 0}, {200, 0, 0}, {201, 0, 0}}));
}

TEST(PrunedTree, HasAFractionOfTheErrorOfTheTreeInPreorder) {
  const std::vector<Rgb8> colors = landscape_colors(200, 150);
  const ColorCounts counts = counts_of(colors);
  for (const int wanted : {16, 64, 256}) {
    const auto error = [&](PaletteMethod method, TreeOrder order) {
      return squared_error(
          colors, make_quantizer(counts, {.colors = wanted, .method = method, .order = order}));
    };
    const double thesis = error(PaletteMethod::thesis, TreeOrder::error);
    const double means = error(PaletteMethod::tree, TreeOrder::preorder);
    EXPECT_LT(means, thesis / 2) << wanted;
    EXPECT_LT(error(PaletteMethod::tree, TreeOrder::error), means) << wanted;
  }
}

TEST(ColorCells, AreTheFinestThatAreFewEnough) {
  const std::vector<Rgb8> colors = random_colors(4000, 2);
  const ColorCounts counts = counts_of(colors);
  for (const std::size_t most :
       {std::size_t{1}, std::size_t{8}, std::size_t{100}, std::size_t{3000}, std::size_t{100000}}) {
    const ColorCells gathered = gather_cells(counts, most);
    EXPECT_LE(gathered.cells.size(), most);
    std::set<std::tuple<int, int, int>> cubes;
    const int side = 256 >> std::min(8, gathered.level + 1);
    for (const Rgb8 color : colors) cubes.insert({color.r / side, color.g / side, color.b / side});
    if (gathered.level < 8) {
      EXPECT_GT(cubes.size(), most);
    }
    std::uint64_t pixels = 0;
    for (const ColorCell& cell : gathered.cells) pixels += cell.sum.count;
    EXPECT_EQ(pixels, colors.size());
  }
}

}  // namespace
}  // namespace terrview

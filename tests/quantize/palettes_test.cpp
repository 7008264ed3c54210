// Palettes without a tree: simple_palettes.h and box_cut.h.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

#include "quantize/box_cut.h"
#include "quantize/quantizer.h"
#include "quantize/simple_palettes.h"
#include "tests/quantize/colors.h"

namespace terrview {
namespace {

TEST(FixedPalette, SpreadsItsBitsOverTheComponents) {
  const Palette palette = fixed_palette(4096);
  ASSERT_EQ(palette.size(), 4096U);
  EXPECT_EQ(palette.front(), Rgb8(0, 0, 0));
  EXPECT_EQ(palette[1], Rgb8(0, 0, 17));
  EXPECT_EQ(palette.back(), Rgb8(255, 255, 255));
  EXPECT_EQ(fixed_palette(256)[0b101'110'01], Rgb8(182, 219, 85));
  EXPECT_EQ(fixed_palette(300).size(), 256U);
  EXPECT_EQ(fixed_palette(2), (Palette{{128, 0, 128}, {128, 255, 128}}));
  for (int p = 0; p <= 16; ++p) EXPECT_EQ(fixed_palette(1 << p).size(), std::size_t{1} << p);
}

TEST(Popularity, TakesTheColorsOfMostPixels) {
  std::vector<Rgb8> colors(5, Rgb8(10, 20, 30));
  colors.insert(colors.end(), 9, Rgb8(200, 100, 50));
  colors.insert(colors.end(), 2, Rgb8(0, 255, 0));
  EXPECT_EQ(popular_colors(counts_of(colors), 2), (Palette{{200, 100, 50}, {10, 20, 30}}));
  EXPECT_EQ(popular_colors(counts_of(colors), 9).size(), 3U);
}

TEST(MedianCut, SharesThePixelsOut) {
  // A grey wedge where every value has as many pixels: boxes of equal width.
  std::vector<Rgb8> colors;
  for (int value = 0; value < 256; ++value) colors.emplace_back(value, value, value);
  const Palette palette = cut_boxes(gather_cells(counts_of(colors)), 4, BoxCut::median);
  ASSERT_EQ(palette.size(), 4U);
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(palette[static_cast<std::size_t>(i)].g, 32 + 64 * i, 1);
}

TEST(MedianCut, CutsAcrossTheLongestSide) {
  const std::vector<Rgb8> colors{{0, 0, 0}, {4, 100, 0}, {0, 4, 0}, {4, 104, 0}};
  EXPECT_EQ(cut_boxes(gather_cells(counts_of(colors)), 2, BoxCut::median),
            (Palette{{0, 2, 0}, {4, 102, 0}}));
}

// The least sum of the parts' errors over every plane, tried one by one.
double least_error(const std::vector<Rgb8>& colors) {
  double least = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    for (int last = 0; last < 255; ++last) {
      double sums[2][5] = {};
      for (const Rgb8 color : colors) {
        double* sum = sums[color[axis] > last ? 1 : 0];
        sum[3] += 1;
        for (int i = 0; i < 3; ++i) {
          sum[i] += color[i];
          sum[4] += color[i] * color[i];
        }
      }
      if (sums[0][3] == 0 || sums[1][3] == 0) continue;
      double error = 0;
      for (const auto& s : sums) error += s[4] - (s[0] * s[0] + s[1] * s[1] + s[2] * s[2]) / s[3];
      least = std::min(least, error);
    }
  }
  return least;
}

TEST(VarianceCut, TakesThePlaneOfLeastError) {
  for (std::uint32_t seed = 1; seed <= 10; ++seed) {
    const std::vector<Rgb8> colors = random_colors(40, seed);
    const Palette palette = cut_boxes(gather_cells(counts_of(colors)), 2, BoxCut::variance);
    ASSERT_EQ(palette.size(), 2U);
    // Some plane parts the colours so that these are the rounded means of its sides.
    double least_found = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
      for (int last = 0; last < 255; ++last) {
        ColorSum parts[2];
        for (const Rgb8 color : colors) parts[color[axis] > last ? 1 : 0].add(color, 1);
        if (parts[0].count == 0 || parts[1].count == 0) continue;
        if (parts[0].mean() == palette[0] && parts[1].mean() == palette[1])
          least_found = std::min(least_found, parts[0].error() + parts[1].error());
      }
    }
    EXPECT_NEAR(least_found, least_error(colors), 1e-6) << seed;
  }
}

TEST(BoxCuts, GiveAsManyColorsAsThereAre) {
  const std::vector<Rgb8> colors = random_colors(300, 4);
  const ColorCells cells = gather_cells(counts_of(colors));
  for (const BoxCut cut : {BoxCut::median, BoxCut::variance}) {
    EXPECT_EQ(cut_boxes(cells, 1, cut).size(), 1U);
    EXPECT_EQ(cut_boxes(cells, 256, cut).size(), 256U);
    EXPECT_EQ(cut_boxes(cells, 5000, cut).size(), cells.cells.size());
  }
}

TEST(Quantizer, KeepsAPictureOfFewColorsAsItIs) {
  const std::vector<Rgb8> colors = random_colors(200, 6);
  const ColorCounts counts = counts_of(colors);
  for (const PaletteMethod method :
       {PaletteMethod::tree, PaletteMethod::thesis, PaletteMethod::popularity,
        PaletteMethod::median_cut, PaletteMethod::variance_cut}) {
    for (const Match match : {Match::leaf, Match::rgb, Match::oklab, Match::ciede2000}) {
      const Quantizer quantizer =
          make_quantizer(counts, {.colors = 256, .method = method, .match = match});
      for (const Rgb8 color : colors) EXPECT_EQ(quantizer.palette[quantizer.find(color)], color);
    }
  }
}

}  // namespace
}  // namespace terrview

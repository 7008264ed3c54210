#include "quantize/rewriter.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "quantize/quantizer.h"
#include "tests/quantize/colors.h"

namespace terrview {
namespace {

constexpr std::uint16_t kNodata = 999;

class Rewritten {
 public:
  Rewritten(const std::vector<Rgb8>& colors, int width_px, const Palette& palette, Dither dither,
            const std::vector<std::uint8_t>& valid = {})
      : palette_(palette), width_(static_cast<std::size_t>(width_px)), indices(colors.size()) {
    Rewriter rewriter(palette, make_quantizer(palette, Match::rgb).find, dither, width_px);
    for (std::size_t at = 0; at < colors.size(); at += width_) {
      const auto mask =
          std::span(valid).subspan(valid.empty() ? 0 : at, valid.empty() ? 0 : width_);
      rewriter.rewrite(std::span(colors).subspan(at, width_), mask, kNodata,
                       std::span(indices).subspan(at, width_));
    }
  }

  // The mean of a component over the valid pixels.
  [[nodiscard]] double mean(int component) const {
    double sum = 0;
    double count = 0;
    for (const std::uint16_t index : indices) {
      if (index == kNodata) continue;
      sum += palette_[index][component];
      ++count;
    }
    return sum / count;
  }

 private:
  Palette palette_;
  std::size_t width_;

 public:
  std::vector<std::uint16_t> indices;
};

const Palette kBlackAndWhite{{0, 0, 0}, {255, 255, 255}};

TEST(Rewriter, WithoutDitheringTakesTheNearestColor) {
  const Rewritten done({{10, 0, 0}, {250, 255, 255}, {127, 127, 127}, {128, 128, 128}}, 2,
                       kBlackAndWhite, Dither::none);
  EXPECT_EQ(done.indices, (std::vector<std::uint16_t>{0, 1, 0, 1}));
}

TEST(Rewriter, DitheringKeepsTheMeanOfAGrey) {
  for (const int grey : {32, 100, 128, 200}) {
    const std::vector<Rgb8> colors(64 * 64, Rgb8(grey, grey, grey));
    for (const Dither dither : {Dither::diffusion, Dither::ordered})
      EXPECT_NEAR(Rewritten(colors, 64, kBlackAndWhite, dither).mean(1), grey, 2) << grey;
  }
}

TEST(Rewriter, OrderedDitheringHasSixtyFourLevels) {
  // Each of the tile's thresholds is crossed once on the way from black to white.
  int before = 0;
  for (int grey = 0; grey < 256; ++grey) {
    const std::vector<Rgb8> colors(64, Rgb8(grey, grey, grey));
    int white = 0;
    for (const std::uint16_t index : Rewritten(colors, 8, kBlackAndWhite, Dither::ordered).indices)
      white += index;
    EXPECT_GE(white, before);
    EXPECT_LE(white, before + 1);
    before = white;
  }
  EXPECT_EQ(before, 64);
}

TEST(Rewriter, OrderedDitheringOfAPixelDependsOnItsPlaceAndColorAlone) {
  std::vector<Rgb8> colors = random_colors(16 * 16, 3);
  const Palette palette = random_colors(20, 4);
  const Rewritten first(colors, 16, palette, Dither::ordered);
  const Rgb8 kept = colors[100];
  colors = random_colors(16 * 16, 5);
  colors[100] = kept;
  EXPECT_EQ(Rewritten(colors, 16, palette, Dither::ordered).indices[100], first.indices[100]);
}

// Four pixels by hand, the second line from right to left.
TEST(Rewriter, DiffusionRunsEveryOtherLineBackwards) {
  const std::vector<Rgb8> colors{{100, 0, 0}, {100, 0, 0}, {100, 0, 0}, {100, 0, 0}};
  const Palette palette{{0, 0, 0}, {160, 0, 0}};
  // First line: 100 -> 160, error -60; 100 - 26.25 = 74 -> 0, error 74. To the second line:
  // left -60 5/16 + 74 3/16 = -4.9, right -60 1/16 + 74 5/16 = 19.4.
  // Second line: right 119 -> 160, error -41; left 100 - 4.9 - 17.9 = 77 -> 0.
  EXPECT_EQ(Rewritten(colors, 2, palette, Dither::diffusion).indices,
            (std::vector<std::uint16_t>{1, 0, 0, 1}));
}

TEST(Rewriter, MakesInvalidPixelsNodataAndLetsNoErrorThrough) {
  const int width = 32;
  std::vector<Rgb8> colors(static_cast<std::size_t>(width * width), Rgb8(90, 90, 90));
  std::vector<std::uint8_t> valid(colors.size(), 255);
  for (std::size_t i = 0; i < valid.size(); i += 3) valid[i] = 0;
  for (const Dither dither : {Dither::none, Dither::diffusion, Dither::ordered}) {
    const Rewritten done(colors, width, kBlackAndWhite, dither, valid);
    for (std::size_t i = 0; i < valid.size(); ++i)
      EXPECT_EQ(done.indices[i] == kNodata, valid[i] == 0);
    // What lies under the mask changes nothing.
    std::vector<Rgb8> others = colors;
    for (std::size_t i = 0; i < valid.size(); i += 3) others[i] = Rgb8(255, 0, 0);
    EXPECT_EQ(Rewritten(others, width, kBlackAndWhite, dither, valid).indices, done.indices);
  }
}

TEST(Rewriter, IndicesReachSixteenBits) {
  Palette palette;
  for (int i = 0; i < 65536; ++i) palette.emplace_back(i / 256, i % 256, 7);
  std::vector<Rgb8> colors{{0, 0, 7}, {255, 255, 7}, {128, 3, 9}};
  EXPECT_EQ(Rewritten(colors, 3, palette, Dither::none).indices,
            (std::vector<std::uint16_t>{0, 65535, 128 * 256 + 3}));
}

}  // namespace
}  // namespace terrview

// The benchmark of the quantisers: that it measures what it says.
#include <gtest/gtest.h>

#include <cmath>

#include "bench/quantize/picture_errors.h"
#include "bench/quantize/quantize_contender.h"
#include "cli/run.h"
#include "ingest/picture_source.h"
#include "quantize/color_difference.h"
#include "tests/support/temporary_folder.h"

namespace terrview {
namespace {

std::vector<QuantizeContender> all_contenders() {
  std::vector<QuantizeContender> all = terrview_quantizers();
  for (const auto& more : {gdal_quantizers(), imagequant_quantizers()})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}

// The view of demo.sh, small.
Picture sample_view() {
  const TemporaryFolder folder;
  const int code = run({TERRVIEW_SOURCE_DIR "/samples/vosges_like.tif", "--eye",
                        "48.012,7.005,1480", "--look-at", "48.04,6.968", "--pitch", "-9", "--sun",
                        "235,28", "--size", "480x300", "-q", "-o", folder / "view.png"});
  EXPECT_EQ(code, 0);
  const PictureSource source(folder / "view.png");
  Picture picture{"view", source.size_px().x, source.size_px().y, {}};
  std::vector<std::uint8_t> valid;
  source.read(0, picture.height_px, picture.pixels, valid);
  return picture;
}

double mean_ciede2000(const Picture& picture, int colors, const std::string& name) {
  for (const QuantizeContender& contender : all_contenders()) {
    if (contender.name != name) continue;
    const auto job = contender.prepare(picture, colors);
    job->run();
    return picture_errors(picture, job->result()).mean_ciede2000;
  }
  ADD_FAILURE() << name;
  return 0;
}

TEST(PictureErrors, AreThoseOfItsPixels) {
  const Picture picture{"a", 2, 2, {{10, 10, 10}, {20, 10, 10}, {10, 10, 10}, {90, 90, 90}}};
  const Rewritten rewritten{{{10, 12, 10}, {80, 95, 90}}, {0, 0, 0, 1}};
  const PictureErrors errors = picture_errors(picture, rewritten);
  EXPECT_DOUBLE_EQ(errors.mean_component, (2 + 10 + 2 + 10) / 4.0);
  EXPECT_EQ(errors.max_component, 10);
  const double small = ciede2000(Rgb8(10, 10, 10), Rgb8(10, 12, 10));
  const double middle = ciede2000(Rgb8(20, 10, 10), Rgb8(10, 12, 10));
  const double large = ciede2000(Rgb8(90, 90, 90), Rgb8(80, 95, 90));
  EXPECT_NEAR(errors.mean_ciede2000, (2 * small + middle + large) / 4, 1e-12);
  EXPECT_NEAR(errors.max_ciede2000, std::max(middle, large), 1e-12);
}

TEST(PictureErrors, BandingIsTheShareOfStepsInSmoothPlaces) {
  // A grey wedge of unseen steps, and an edge in its middle that is seen before and after.
  Picture wedge{"wedge", 21, 1, {}};
  Rewritten two_greys{{{100, 100, 100}, {109, 109, 109}, {200, 200, 200}}, {}};
  for (int x = 0; x < 21; ++x) {
    wedge.pixels.emplace_back(glm::ivec3(x < 20 ? 100 + x / 2 : 200));
    two_greys.indices.push_back(static_cast<std::uint16_t>(x < 10 ? 0 : x < 20 ? 1 : 2));
  }
  EXPECT_DOUBLE_EQ(picture_errors(wedge, two_greys).banding, 1.0 / 19);
  EXPECT_EQ(picture_errors(wedge, {{{100, 100, 100}}, std::vector<std::uint16_t>(21, 0)}).banding,
            0);
}

TEST(QuantizeContenders, GiveEveryPixelAColorOfTheirPalette) {
  const Picture picture = sample_view();
  for (const QuantizeContender& contender : all_contenders()) {
    SCOPED_TRACE(contender.name);
    const auto job = contender.prepare(picture, 64);
    job->run();
    const Rewritten rewritten = job->result();
    EXPECT_GT(rewritten.palette.size(), 32U);
    EXPECT_LE(rewritten.palette.size(), 64U);
    ASSERT_EQ(rewritten.indices.size(), picture.pixels.size());
    for (const std::uint16_t index : rewritten.indices) ASSERT_LT(index, rewritten.palette.size());
    EXPECT_LT(picture_errors(picture, rewritten).mean_ciede2000, 20);
  }
}

TEST(QuantizeContenders, TheThesisByPixelIsTheThesis) {
  const Picture picture = sample_view();
  const auto result = [&](const std::string& name) {
    for (const QuantizeContender& contender : terrview_quantizers()) {
      if (contender.name != name) continue;
      const auto job = contender.prepare(picture, 200);
      job->run();
      return job->result();
    }
    return Rewritten{};
  };
  EXPECT_EQ(result("thesis-by-pixel").palette, result("thesis").palette);
  EXPECT_EQ(result("thesis-by-pixel").indices, result("thesis").indices);
}

TEST(QuantizeContenders, OurTreeHasLessThanFourFifthsOfTheErrorOfGdalsMedianCut) {
  const Picture picture = sample_view();
  for (const int colors : {64, 256})
    EXPECT_LT(mean_ciede2000(picture, colors, "tree"),
              0.8 * mean_ciede2000(picture, colors, "gdal-median-cut"))
        << colors;
}

}  // namespace
}  // namespace terrview

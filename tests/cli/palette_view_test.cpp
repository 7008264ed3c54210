// --palette and its company on a view: docs/cli.md.
#include "cli/palette_file.h"
#include "quantize/color_difference.h"
#include "tests/cli/small_picture.h"
#include "tests/cli/small_view.h"

namespace terrview {
namespace {

using Names = std::vector<std::string>;
using PaletteView = SmallView;

TEST_F(PaletteView, IsTheViewQuantized) {
  view("-o true.png");
  view("-o a.png --palette 40 --save-palette a.gpl");
  view("-o a.tif --palette 40");
  EXPECT_EQ(run(words("quantize true.png -q -o b.png --colors 40")).exit_code, 0);
  const ReadPicture picture = read_picture(path("a.png"));
  EXPECT_EQ(picture.bands, 1);
  EXPECT_EQ(picture.table.size(), 40U);
  EXPECT_EQ(picture.table, read_palette(path("a.gpl")));
  EXPECT_EQ(picture.colors, read_picture(path("b.png")).colors);
  EXPECT_EQ(picture.colors, read_picture(path("a.tif")).colors);
}

TEST_F(PaletteView, SharesAPalette) {
  view("-o a.png --palette 20 --save-palette a.json");
  view("-o b.png --use-palette a.json --heading 10 --eye 48,7,+50 --dither diffusion");
  EXPECT_EQ(read_picture(path("b.png")).table, read_palette(path("a.json")));
}

TEST_F(PaletteView, OfMoreColorsThanTheTableHoldsKeepsThem) {
  view("-o a.png --palette 300");
  view("-o a.tif --palette 300");
  EXPECT_EQ(read_picture(path("a.png")).colors, read_picture(path("a.tif")).colors);
}

TEST_F(PaletteView, KeepsItsMetadata) {
  view("-o a.png --palette 20 --dither ordered");
  const GDALDatasetUniquePtr png(GDALDataset::Open(path("a.png").c_str()));
  const char* text = png->GetMetadataItem("terrview_view");
  ASSERT_NE(text, nullptr);
  const nlohmann::json said = nlohmann::json::parse(text);
  EXPECT_EQ(said.at("palette").at("colors"), 20);
  EXPECT_EQ(said.at("palette").at("dither"), "ordered");
  view("-o a.tif --palette 20");
  const GDALDatasetUniquePtr tif(GDALDataset::Open(path("a.tif").c_str()));
  ASSERT_NE(tif->GetMetadataItem("TIFFTAG_IMAGEDESCRIPTION"), nullptr);
}

TEST_F(PaletteView, IsTheSameForAnyNumberOfThreads) {
  for (const std::string threads : {"1", "3"})
    view("-o " + threads + ".png --palette 64 --dither diffusion --threads " + threads);
  EXPECT_TRUE(bytes("1.png") == bytes("3.png"));
}

TEST_F(PaletteView, RefusesInOneLine) {
  write_text(path("bad.gpl"), "GIMP Palette\n1\n");
  const Names before = outputs();
  const std::string beginning = "hills.tif --eye 48,7,+20 --size 16x12 ";
  expect_refused(run(words(beginning + "--palette 1")), {"--palette 1", "2 to 65536"});
  expect_refused(run(words(beginning + "-o a.exr --palette 9")), {"a.exr", "png"});
  expect_refused(run(words(beginning + "--dither ordered")), {"--dither", "--palette"});
  expect_refused(run(words(beginning + "--save-palette p.gpl")), {"--save-palette", "--palette"});
  expect_refused(run(words(beginning + "--use-palette bad.gpl")), {"bad.gpl", "line 2"});
  expect_refused(run(words(beginning + "--use-palette bad.gpl --palette 4")), {"--use-palette"});
  expect_refused(run(words(beginning + "--palette 4 --progressive p.png")), {"--progressive"});
  expect_refused(run(words(beginning + "-o a.png --palette 4 --save-palette a.txt")), {"a.txt"});
  EXPECT_EQ(outputs(), before);
}

}  // namespace
}  // namespace terrview

// One test per promise of ingest/color_ramp_file.h.
#include "ingest/color_ramp_file.h"

#include <gtest/gtest.h>

#include <limits>

#include "terrain/error.h"
#include "tests/ingest/test_raster.h"

namespace terrview {
namespace {

ColorRamp parse(const std::string& text) {
  return parse_color_ramp(text, "ramp.txt", {200, 1200, false});
}

std::string parse_refusal(const std::string& text) {
  try {
    const ColorRamp ramp = parse(text);
    return "";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return error.what();
  }
}

TEST(ColorRampFile, ColorReliefTextHoldsAHeightAndAColourOnEachLine) {
  const ColorRamp ramp = parse("0 0 128 0\n1000.5 255 255 255\n");
  ASSERT_EQ(ramp.stops.size(), 2U);
  EXPECT_EQ(ramp.stops[0].height_m, 0);
  EXPECT_EQ(ramp.stops[0].color, from_srgb8(0, 128, 0));
  EXPECT_EQ(ramp.stops[1].height_m, 1000.5);
  EXPECT_EQ(ramp.interpolation, RampInterpolation::linear);
}

TEST(ColorRampFile, AnySeparatorThatGdaldemKnowsIsRead) {
  for (const char* line :
       {"10 1 2 3", "10,1,2,3", "10\t1\t2\t3", "10:1:2:3", "  10, 1 :2\t 3 \r", "+10 1 2 3 77"}) {
    const ColorRamp ramp = parse(line);
    ASSERT_EQ(ramp.stops.size(), 1U) << line;
    EXPECT_EQ(ramp.stops[0].height_m, 10) << line;
    EXPECT_EQ(ramp.stops[0].color, from_srgb8(1, 2, 3)) << line;
  }
}

TEST(ColorRampFile, NamesOfColoursAreThoseOfGdaldem) {
  const ColorRamp ramp = parse("0 brown\n1 GREY\n2 orange 255\n");
  ASSERT_EQ(ramp.stops.size(), 3U);
  EXPECT_EQ(ramp.stops[0].color, from_srgb8(150, 75, 0));
  EXPECT_EQ(ramp.stops[1].color, from_srgb8(128, 128, 128));
  EXPECT_EQ(ramp.stops[2].color, from_srgb8(255, 165, 0));
}

TEST(ColorRampFile, PercentagesAreOfTheRange) {
  const ColorRamp ramp = parse("0% black\n25% red\n100% white\n");
  ASSERT_EQ(ramp.stops.size(), 3U);
  EXPECT_EQ(ramp.stops[0].height_m, 200);
  EXPECT_EQ(ramp.stops[1].height_m, 450);
  EXPECT_EQ(ramp.stops[2].height_m, 1200);
}

TEST(ColorRampFile, StopsAreSortedAndTheRestIsPassedOver) {
  const ColorRamp ramp =
      parse("\xEF\xBB\xBF# a comment\n\nnv 1 2 3\nNV 0 0 0 0\n900 white\n100 black\n");
  ASSERT_EQ(ramp.stops.size(), 2U);
  EXPECT_EQ(ramp.stops[0].height_m, 100);
  EXPECT_EQ(ramp.stops[1].height_m, 900);
}

TEST(ColorRampFile, QgisColourMapsAreRead) {
  const std::string head = "# QGIS Generated Color Map Export File\nINTERPOLATION:";
  for (const auto& [word, kind] : {std::pair{"INTERPOLATED", RampInterpolation::linear},
                                   {"DISCRETE", RampInterpolation::discrete},
                                   {"EXACT", RampInterpolation::exact}}) {
    const ColorRamp ramp =
        parse(head + word + "\n558,43,131,186,255,558 m: low ground\n1413,215,25,28,255,1413\n");
    ASSERT_EQ(ramp.stops.size(), 2U);
    EXPECT_EQ(ramp.interpolation, kind);
    EXPECT_EQ(ramp.stops[0].height_m, 558);
    EXPECT_EQ(ramp.stops[0].color, from_srgb8(43, 131, 186));
  }
}

TEST(ColorRampFile, TheLastClassOfADiscreteMapMayBeInfinite) {
  const std::string classes = "558,1,2,3,255,low\ninf,4,5,6,255,high\n";
  const ColorRamp ramp = parse("INTERPOLATION:DISCRETE\n" + classes);
  EXPECT_EQ(ramp.at(9000), from_srgb8(4, 5, 6));
  EXPECT_TRUE(says(parse_refusal("INTERPOLATION:INTERPOLATED\n" + classes), {"line 3"}));
}

TEST(ColorRampFile, ErrorsNameTheFileTheLineAndTheRemedy) {
  for (const char* line :
       {"12x 1 2 3", "500", "500 1 2", "500 mauve", "500 1 2 256", "500 1 -2 3", "500 1 2 x",
        "120% 1 2 3", "nan 1 2 3", "inf 1 2 3", "1e999 1 2 3", "0 1 2 3 100 4 5 6", "B 0 0 0"}) {
    EXPECT_TRUE(says(parse_refusal("# heights\n0 black\n" + std::string(line) + "\n"),
                     {"ramp.txt: line 3: ", "HEIGHT RED GREEN BLUE"}))
        << line;
  }
  EXPECT_TRUE(says(parse_refusal("INTERPOLATION:CUBIC\n"), {"line 1", "CUBIC", "DISCRETE"}));
  EXPECT_TRUE(says(parse_refusal("# nothing\n"), {"ramp.txt", "no colours"}));
}

TEST(ColorRampFile, FilesAreReadByPath) {
  const TemporaryFolder folder;
  write_text(folder / "ramp.txt", "0 black\n100 white\n");
  EXPECT_EQ(read_color_ramp(folder / "ramp.txt", {0, 1, false}).stops.size(), 2U);
  EXPECT_THROW(static_cast<void>(read_color_ramp(folder / "none.txt", {0, 1, false})), InputError);
}

}  // namespace
}  // namespace terrview

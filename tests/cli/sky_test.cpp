// `terrview sky`, as a user runs it.
#include <gdal_priv.h>
#include <gtest/gtest.h>

#include "cli/color_table_file.h"
#include "cli/field_arguments.h"
#include "terrain/error.h"
#include "tests/cli/small_view.h"

namespace terrview {
namespace {

using Sky = SmallView;

TEST(ParseH, ReadsOneValueOrValuesByDivision) {
  EXPECT_EQ(parse_h("0.5"), std::vector<double>{0.5});
  EXPECT_EQ(parse_h("0,3:0.3"), (std::vector<double>{0, 0, 0, 0.3}));
  EXPECT_EQ(parse_h("0.1,1:0.2,3:1"), (std::vector<double>{0.1, 0.2, 0.2, 1}));
}

TEST(ParseH, RefusesWhatIsNoH) {
  for (const char* text : {"", "x", "0.5,", "0.5,0.6", "3:0.3", "0.5,2:0.3,1:0.2", "5", "0.5,99:1"})
    EXPECT_THROW((void)parse_h(text), InputError) << text;
}

TEST(ParseLevels, ReadsOneNumberOrTwo) {
  EXPECT_EQ(parse_levels("7"), glm::ivec2(7, 7));
  EXPECT_EQ(parse_levels("4:7"), glm::ivec2(4, 7));
  for (const char* text : {"", "x", "4:", ":4", "-1", "4:99", "4,7", "4:5:6"})
    EXPECT_THROW((void)parse_levels(text), InputError) << text;
}

TEST(ColorTableFile, ComesBackAsItWasWritten) {
  ColorTable table = sky_table(0.4);
  table.noise = 0.01;
  const ColorTable back = parse_color_table(color_table_json(table), "here");
  for (double address = 0; address <= 1; address += 0.01)
    EXPECT_LT(glm::distance(table.at(address), back.at(address)), 1e-6F);
  EXPECT_EQ(back.window.middle, table.window.middle);
  EXPECT_EQ(back.window.width, table.window.width);
  EXPECT_EQ(back.clear_until, table.clear_until);
  EXPECT_EQ(back.cloud_from, table.cloud_from);
  EXPECT_EQ(back.noise, table.noise);
}

TEST(ColorTableFile, RefusesEveryTruncation) {
  const std::string json = color_table_json(sky_table(0.5));
  for (std::size_t n = 0; n < json.size(); ++n)
    EXPECT_THROW((void)parse_color_table(json.substr(0, n), "here"), InputError) << n;
}

TEST(ColorTableFile, RefusesWhatIsNoTable) {
  const auto with_red = [](const std::string& red) {
    return R"({"red": )" + red + R"(, "green": [[0, 1]], "blue": [[0, 1]]})";
  };
  EXPECT_NO_THROW((void)parse_color_table(with_red("[[0, 0], [0.5, 1], [0.5, 255]]"), "here"));
  for (const char* red : {"1", "[]", "[1]", "[[0]]", "[[0, \"a\"]]", "[[0.5, 1], [0.4, 1]]",
                          "[[0, 256]]", "[[2, 1]]", "[[-1, 1]]"})
    EXPECT_THROW((void)parse_color_table(with_red(red), "here"), InputError) << red;
  EXPECT_THROW((void)parse_color_table(R"({"red": [[0, 1]]})", "here"), InputError);
  EXPECT_THROW((void)parse_color_table("[]", "here"), InputError);
}

TEST_F(Sky, WritesTheSameBytesForAnyNumberOfThreads) {
  const std::string line = "sky --size 200x150 --levels 6 -q -o ";
  ASSERT_EQ(run(words(line + "one.png --threads 1")).exit_code, 0);
  ASSERT_EQ(run(words(line + "four.png --threads 4")).exit_code, 0);
  EXPECT_TRUE(bytes("one.png") == bytes("four.png"));
}

TEST_F(Sky, EveryChoiceChangesThePicture) {
  const std::string line = "sky --size 60x40 --overwrite -q -o ";
  ASSERT_EQ(run(words(line + "plain.png")).exit_code, 0);
  for (const char* choice :
       {"--seed 2", "--clouds 0.8", "--h 0.2", "--levels 3:5", "--field midpoint", "--law coin",
        "--ramp wood", "--noise 0.1", "--cells 3,2", "--origin 1,0"}) {
    ASSERT_EQ(run(words(line + "other.png " + choice)).exit_code, 0) << choice;
    EXPECT_FALSE(bytes("other.png") == bytes("plain.png")) << choice;
  }
}

TEST_F(Sky, ReadsTheTableThatItWrote) {
  ASSERT_EQ(run(words("sky --size 60x40 --clouds 0.5 -q -o a.png --write-ramp t.json")).exit_code,
            0);
  ASSERT_EQ(run(words("sky --size 60x40 --ramp t.json -q -o b.png")).exit_code, 0);
  EXPECT_TRUE(bytes("a.png") == bytes("b.png"));
}

TEST_F(Sky, InPerspectiveWritesTheSameBytesForAnyNumberOfThreads) {
  for (const std::string projection :
       {"perspective --pitch 30 --roll 10", "cylindrical --fov 360"}) {
    const std::string line =
        "sky --size 200x100 --overwrite -q --projection " + projection + " --threads ";
    ASSERT_EQ(run(words(line + "1 -o one.png")).exit_code, 0);
    ASSERT_EQ(run(words(line + "4 -o four.png")).exit_code, 0);
    EXPECT_TRUE(bytes("one.png") == bytes("four.png"));
  }
}

TEST_F(Sky, EveryChoiceOfAViewChangesThePicture) {
  const std::string line =
      "sky --projection perspective --size 60x40 --clouds 0.6 --overwrite -q -o ";
  ASSERT_EQ(run(words(line + "plain.png")).exit_code, 0);
  for (const char* choice :
       {"--heading 20", "--pitch 30", "--roll 10", "--fov 40", "--sun 10,20", "--altitude 1000",
        "--cell 3000", "--layer plane", "--sky-model gradient", "--turbidity 5", "--leaf 20",
        "--seed 2", "--ramp sunset"}) {
    ASSERT_EQ(run(words(line + "other.png " + choice)).exit_code, 0) << choice;
    EXPECT_FALSE(bytes("other.png") == bytes("plain.png")) << choice;
  }
}

TEST_F(Sky, IsWrittenInTheFormatNamed) {
  ASSERT_EQ(run(words("sky --size 20x10 -q --of JPEG")).exit_code, 0);
  EXPECT_EQ(bytes("sky.jpeg").substr(0, 2), "\xff\xd8");
  ASSERT_EQ(run(words("sky --size 20x10 -q --of EXR -o named")).exit_code, 0);
  EXPECT_EQ(bytes("named").substr(0, 4), "\x76\x2f\x31\x01");
  ASSERT_EQ(run(words("sky --size 90x60 -q -o fine.jpg --co QUALITY=95")).exit_code, 0);
  ASSERT_EQ(run(words("sky --size 90x60 -q -o coarse.jpg --co QUALITY=10")).exit_code, 0);
  EXPECT_LT(bytes("coarse.jpg").size(), bytes("fine.jpg").size());
}

TEST_F(Sky, SaysInThePictureAllThatMakesIt) {
  const auto said = [&](const std::string& line) {
    EXPECT_EQ(run(words("sky --size 20x10 -q --overwrite -o a.png " + line)).exit_code, 0);
    GDALAllRegister();
    const GDALDatasetUniquePtr picture(GDALDataset::Open(path("a.png").c_str()));
    const char* text = picture ? picture->GetMetadataItem("terrview_sky") : nullptr;
    return nlohmann::json::parse(text != nullptr ? text : "{}");
  };
  const nlohmann::json flat =
      said("--seed 5 --levels 3:4 --h 0.5 --field midpoint --law coin --cells 2,3 --origin 1,0");
  EXPECT_EQ(flat.at("field"), nlohmann::json::parse(R"({"seed": 5, "levels": [3, 4], "h": [0.5],
                                                        "kind": "midpoint", "law": "coin"})"));
  EXPECT_EQ(flat.at("flat"),
            nlohmann::json::parse(R"({"cells": [2.0, 3.0], "origin": [1.0, 0.0]})"));
  EXPECT_EQ(flat.at("table").at("middle"), sky_table(0.35).window.middle);
  EXPECT_FALSE(flat.contains("view"));
  const nlohmann::json view = said("--projection perspective --sun 100,20 --fov 50").at("view");
  EXPECT_EQ(view.at("sun").at("azimuth"), 100);
  EXPECT_NEAR(view.at("fov").get<double>(), 50, 1e-12);
  EXPECT_NEAR(view.at("pitch").get<double>(), 20, 1e-12);
  EXPECT_EQ(view.at("layer"), "shell");
}

TEST_F(Sky, ShowsItsProgressWhereAsked) {
  const std::string line = "sky --projection perspective --size 26x20 --of ppm -o ";
  EXPECT_TRUE(
      says(run(words(line + "a.ppm --progress")).err, {"painting [#", " %", "wrote a.ppm"}));
}

TEST_F(Sky, IsNeverTheTableThatItReads) {
  ASSERT_EQ(run(words("sky --size 20x10 -q -o a.png --write-ramp t.json")).exit_code, 0);
  const std::string before = bytes("t.json");
  expect_refused(run(words("sky --ramp t.json --of png --overwrite -o ./t.json")),
                 {"t.json", "input"});
  EXPECT_EQ(bytes("t.json"), before);
  expect_refused(run(words("sky --of png -o b --write-ramp ./b")), {"'b'", "two outputs"});
}

TEST_F(Sky, RefusesInOneLine) {
  expect_refused(run(words("sky --of bmp")), {"bmp", "--of"});
  expect_refused(run(words("sky --co ROUGH=1")), {"ROUGH=1", "QUALITY"});
  expect_refused(run(words("sky --projection perspective --levels 3:5")),
                 {"--levels", "one number"});
  expect_refused(run(words("sky --projection perspective --fov 190")), {"--fov"});
  expect_refused(run(words("sky --sun 10,100")), {"--sun 10,100"});
  expect_refused(run(words("sky --turbidity 12")), {"--turbidity"});
  expect_refused(run(words("sky --clouds 2")), {"--clouds"});
  expect_refused(run(words("sky --ramp plaid")), {"--ramp plaid", "wood"});
  expect_refused(run(words("sky --h rough")), {"--h rough"});
  expect_refused(run(words("sky --levels 40")), {"--levels 40"});
  expect_refused(run(words("sky --cells 0")), {"--cells 0"});
  expect_refused(run(words("sky --size 0x4")), {"--size"});
  expect_refused(run(words("sky -o sky.xyz")), {"sky.xyz"});
}

}  // namespace
}  // namespace terrview

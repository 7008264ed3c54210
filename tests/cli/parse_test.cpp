// One test per promise of cli/parse.h.
#include "cli/parse.h"

#include <gtest/gtest.h>

#include <functional>

#include "terrain/error.h"

namespace terrview {
namespace {

void expect_refused(const std::function<void()>& parse, const std::string& option) {
  try {
    parse();
    ADD_FAILURE() << option << " accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).rfind(option, 0), 0U) << error.what();
  }
}

TEST(ParseNumber, TakesTheWholeTextAsAFiniteNumber) {
  EXPECT_EQ(parse_number("--x", "12"), 12);
  EXPECT_EQ(parse_number("--x", "-.5"), -0.5);
  EXPECT_EQ(parse_number("--x", "+1e3"), 1000);
  for (const char* text :
       {"", "x", "1x", "1 2", "nan", "inf", "-inf", "0x10", "1,5", "--1", "1e999"})
    expect_refused([&] { static_cast<void>(parse_number("--x", text)); }, "--x");
}

TEST(ParseNumbers, WantsAsManyAsSaid) {
  EXPECT_EQ(parse_numbers("--x", "1,-2", 2, 3), (std::vector<double>{1, -2}));
  EXPECT_EQ(parse_numbers("--x", "1, 2, 3", 2, 3), (std::vector<double>{1, 2, 3}));
  for (const char* text : {"1", "1,2,3,4", "1,,2", ",1", "1,"})
    expect_refused([&] { static_cast<void>(parse_numbers("--x", text, 2, 3)); }, "--x");
}

TEST(ParseHeight, IsAboveTheGroundWhereItBeginsWithPlus) {
  EXPECT_FALSE(parse_height("--x", "120.5").above_ground);
  EXPECT_FALSE(parse_height("--x", "-3").above_ground);
  EXPECT_TRUE(parse_height("--x", "+2").above_ground);
  EXPECT_EQ(parse_height("--x", "+2").height_m, 2);
  for (const char* text : {"", "+", "high", "2m"})
    expect_refused([&] { static_cast<void>(parse_height("--x", text)); }, "--x");
}

TEST(ParseEye, IsLatitudeLongitudeHeight) {
  const EyePlace eye = parse_eye("-33.9,18.4,+2");
  ASSERT_TRUE(eye.geographic);
  EXPECT_EQ(eye.geographic->latitude_deg, -33.9);
  EXPECT_EQ(eye.geographic->longitude_deg, 18.4);
  EXPECT_EQ(eye.height_m, 2);
  EXPECT_TRUE(eye.above_ground);
  EXPECT_FALSE(eye.projected);
  for (const char* text : {"1,2", "1,2,3,4", "90.1,0,0", "0,361,0", "0,-361,0", "a,b,c"})
    expect_refused([&] { static_cast<void>(parse_eye(text)); }, "--eye");
}

TEST(ParseEyeXy, TakesAnyCoordinates) {
  const EyePlace eye = parse_eye_xy("400000,5300000.5,812");
  ASSERT_TRUE(eye.projected);
  EXPECT_EQ(*eye.projected, glm::dvec2(400000, 5300000.5));
  EXPECT_EQ(eye.height_m, 812);
  EXPECT_FALSE(eye.above_ground);
  EXPECT_FALSE(eye.geographic);
}

TEST(ParseLookAt, IsTheGroundWithoutAHeight) {
  const Target target = parse_look_at("48,7");
  ASSERT_TRUE(target.geographic);
  EXPECT_TRUE(target.height.above_ground);
  EXPECT_EQ(target.height.height_m, 0);
  EXPECT_FALSE(parse_look_at("48,7,900").height.above_ground);
  EXPECT_EQ(parse_look_at_xy("4,5,+6").height.height_m, 6);
  EXPECT_EQ(*parse_look_at_xy("4,5,+6").projected, glm::dvec2(4, 5));
  for (const char* text : {"48", "48,7,900,1", "91,7"})
    expect_refused([&] { static_cast<void>(parse_look_at(text)); }, "--look-at");
}

TEST(ParseSize, IsWidthXHeightInWholePixels) {
  EXPECT_EQ(parse_size("1280x720"), glm::ivec2(1280, 720));
  for (const char* text : {"", "x", "12", "12x", "x12", "1.5x2", "1x2x3", "12X13", "1e2x10"})
    expect_refused([&] { static_cast<void>(parse_size(text)); }, "--size");
}

TEST(ParseCreationOption, SplitsAtTheFirstEqualsSign) {
  EXPECT_EQ(parse_creation_option("A=b=c"), (std::pair<std::string, std::string>("A", "b=c")));
  EXPECT_EQ(parse_creation_option("A=").second, "");
  for (const char* text : {"", "A", "=b"})
    expect_refused([&] { static_cast<void>(parse_creation_option(text)); }, "--co");
}

TEST(ParseWindow, IsFourWholeNumbers) {
  EXPECT_EQ(parse_window("0,10,256,128"), (std::array<int, 4>{0, 10, 256, 128}));
  for (const char* text : {"0,0,1", "0,0,1,1.5", "0,0,1,1e300", "a,0,1,1"})
    expect_refused([&] { static_cast<void>(parse_window(text)); }, "--window");
}

TEST(LowerCase, ChangesAsciiLettersAlone) { EXPECT_EQ(lower_case("PNG \xc9.9z"), "png \xc9.9z"); }

}  // namespace
}  // namespace terrview

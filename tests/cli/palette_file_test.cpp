// One promise: a palette comes back as it was written, and every damaged one is refused.
#include "cli/palette_file.h"

#include <gtest/gtest.h>

#include "terrain/error.h"

namespace terrview {
namespace {

const Palette kPalette{{0, 0, 0}, {255, 128, 7}, {12, 34, 56}};

TEST(PaletteFile, ComesBackAsItWasWritten) {
  for (const char* name : {"a.gpl", "a.json"})
    EXPECT_EQ(parse_palette(palette_text(kPalette, name), name), kPalette);
}

TEST(PaletteFile, ReadsWhatGimpWrites) {
  EXPECT_EQ(parse_palette("GIMP Palette\r\nName: Some thing\r\nColumns: 3\r\n# a comment\r\n\r\n"
                          "  0   0   0\tBlack\r\n255 128   7 Name: of a colour\r\n 12\t34\t56\r\n",
                          "a.gpl"),
            kPalette);
}

// A GIMP palette has no end mark: what is left of it is its beginning.
TEST(PaletteFile, OfAnyLengthIsReadOrRefused) {
  const std::string json = palette_text(kPalette, "a.json");
  for (std::size_t n = 0; n + 1 < json.size(); ++n)
    EXPECT_THROW(static_cast<void>(parse_palette(json.substr(0, n), "a")), InputError) << n;
  const std::string gpl = palette_text(kPalette, "a.gpl");
  int refused = 0;
  for (std::size_t n = 0; n < gpl.size(); ++n) {
    try {
      EXPECT_LE(parse_palette(gpl.substr(0, n), "a").size(), kPalette.size());
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 40);
}

TEST(PaletteFile, RefusesWhatIsNoColor) {
  for (const char* text :
       {"GIMP Palette\n1 2\n", "GIMP Palette\n1 2 256\n", "GIMP Palette\n-1 2 3\n",
        "GIMP Palette\nred\n", "GIMP Palette\n99999999999999999999 0 0\n", "GIMP Palette\n",
        R"({"colors": [[1, 2]]})", R"({"colors": [[1, 2, 3, 4]]})", R"({"colors": [[1, 2, 2.5]]})",
        R"({"colors": [[1, 2, -3]]})", R"({"colors": [[1, 2, 18446744073709551615]]})",
        R"({"colors": ["red"]})", R"({"colors": {}})", R"({"colors": []})", R"({"colours": []})",
        "[]", "", "\xff\xfe"})
    EXPECT_THROW(static_cast<void>(parse_palette(text, "a")), InputError) << text;
}

TEST(PaletteFile, HasAtMost65536Colors) {
  std::string text = "GIMP Palette\n";
  for (int i = 0; i < 65536; ++i) text += "1 2 3\n";
  EXPECT_EQ(parse_palette(text, "a").size(), 65536U);
  EXPECT_THROW(static_cast<void>(parse_palette(text + "1 2 3\n", "a")), InputError);
}

}  // namespace
}  // namespace terrview

// Text as ink: render/text.h.
#include "render/text.h"

#include <gtest/gtest.h>

#include <map>
#include <utility>

#include "terrain/error.h"

namespace terrview {
namespace {

using Ink = std::map<std::pair<int, int>, float>;  // by row and column

Ink ink_of(const Font& font, const std::string& text) {
  Ink ink;
  font.draw(text, [&](glm::ivec2 at, float share) {
    EXPECT_GT(share, 0);
    EXPECT_LE(share, 1);
    ink[{at.y, at.x}] = share;
  });
  return ink;
}

TEST(FontText, StandsOnItsLineWithinItsWidth) {
  const Font font(usual_font(), 40);
  const Ink ink = ink_of(font, "HILL");
  ASSERT_FALSE(ink.empty());
  EXPECT_EQ(ink.rbegin()->first.first, -1);
  EXPECT_GE(ink.begin()->first.first, -font.ascent_px());
  for (const auto& [at, share] : ink) {
    EXPECT_GE(at.second, 0);
    EXPECT_LE(at.second, font.width_px("HILL"));
  }
}

// What is above the letters of "a" is two dots.
TEST(FontText, HasTheAccentsOfUtf8) {
  const Font font(usual_font(), 40);
  const Ink plain = ink_of(font, "a");
  Ink dotted = ink_of(font, "ä");
  EXPECT_EQ(font.width_px("a"), font.width_px("ä"));
  const int top = plain.begin()->first.first;
  std::map<int, int> columns;
  for (const auto& [at, share] : dotted)
    if (at.first < top - 1) ++columns[at.second];
  ASSERT_FALSE(columns.empty());
  int parts = 1;
  for (auto next = std::next(columns.begin()); next != columns.end(); ++next)
    parts += next->first > std::prev(next)->first + 1 ? 1 : 0;
  EXPECT_EQ(parts, 2);
}

TEST(FontText, SurvivesWhatIsNoUtf8) {
  const Font font(usual_font(), 13);
  const int replaced = font.width_px("\xef\xbf\xbd");
  for (const char* broken : {"\xe4", "\xc3", "\x80", "\xff", "\xf0\x9f"})
    EXPECT_GE(font.width_px(broken), replaced) << broken;
  EXPECT_EQ(font.width_px(""), 0);
}

TEST(FontText, NeedsAFont) {
  EXPECT_THROW(Font("/nowhere/a.ttf", 12), InputError);
  EXPECT_THROW(Font("/etc/passwd", 12), InputError);
}

}  // namespace
}  // namespace terrview

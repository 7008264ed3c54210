// Promises of cli/batch/output_template.h.
#include "cli/batch/output_template.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <filesystem>

#include "terrain/error.h"

namespace terrview {
namespace {

JobRow row(const std::map<std::string, std::string>& cells) {
  JobRow row;
  for (const auto& [column, text] : cells) row.cells[column] = {text};
  return row;
}

std::string filled(const std::string& text, const std::map<std::string, std::string>& cells,
                   int index = 7) {
  return OutputTemplate("-o", text).fill(row(cells), index);
}

TEST(OutputTemplate, PutsCellsAndNumbersIntoItsHoles) {
  EXPECT_EQ(filled("out/{name}.png", {{"name", "Grand Ballon"}}), "out/Grand Ballon.png");
  EXPECT_EQ(filled("{a}{b}-{index}-{index:04}.png", {{"a", "x"}, {"b", "y"}}), "xy-7-0007.png");
  EXPECT_EQ(filled("{index:02}", {}, 1234), "1234");
  EXPECT_EQ(filled("{{{a}}}.png", {{"a", "x"}}), "{x}.png");
  EXPECT_EQ(filled("plain.png", {}), "plain.png");
}

TEST(OutputTemplate, ThatIsNoneIsRefused) {
  for (const std::string text : {"{", "{a", "a}", "{}", "{index:4}", "{index:}", "{index:0x}"})
    EXPECT_THROW(OutputTemplate("-o", text), InputError) << text;
}

TEST(OutputTemplate, RefusesCellsThatLeadElsewhere) {
  for (const std::string cell : {"", "..", ".", "../x", "/etc/x", "a/b", "a\nb", "\x7f"})
    EXPECT_THROW(static_cast<void>(filled("out/{name}", {{"name", cell}})), InputError) << cell;
  EXPECT_THROW(static_cast<void>(filled("{a}{b}", {{"a", "."}, {"b", "."}})), InputError);
  EXPECT_THROW(static_cast<void>(filled("{name}", {})), InputError);
}

RC_GTEST_PROP(OutputTemplateProperty, NeverLeavesItsFolder, ()) {
  const auto cell = rc::gen::container<std::string>(rc::gen::elementOf(std::string("./a\\")));
  const std::string text = *rc::gen::elementOf(
      std::vector<std::string>{"out/{a}", "out/{a}{b}", "out/.{a}", "out/{a}/{b}", "out/{a}.{b}"});
  std::string path;
  try {
    path = filled(text, {{"a", *cell}, {"b", *cell}});
  } catch (const InputError&) {
    return;
  }
  const auto place = std::filesystem::path("/root/" + path).lexically_normal().string();
  RC_ASSERT(place.starts_with("/root/out/") && place.size() > 10);
  RC_ASSERT(std::count(path.begin(), path.end(), '/') == std::count(text.begin(), text.end(), '/'));
}

TEST(OutputTemplate, KnowsItsColumnsAndItsBeginning) {
  const OutputTemplate one("-o", "out/{region}/{name}-{index:03}.png");
  EXPECT_EQ(one.columns(), (std::vector<std::string>{"region", "name"}));
  EXPECT_EQ(one.beginning(), "out/");
  EXPECT_EQ(one.numbered_pattern(), "");
  EXPECT_EQ(OutputTemplate("-o", "f/100%-{index:05}.png").numbered_pattern(), "f/100%%-%05d.png");
}

}  // namespace
}  // namespace terrview

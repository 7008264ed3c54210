// Help, docs/cli.md and the man page tell of the same options.
#include <gtest/gtest.h>

#include <cctype>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/cli/program.h"
#include "tests/ingest/test_raster.h"
#include "tests/support/temporary_folder.h"

namespace terrview {
namespace {

using Names = std::set<std::string>;

// The first groups of all matches.
std::vector<std::string> matches(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern, std::regex::ECMAScript | std::regex::multiline);
  std::vector<std::string> found;
  for (std::sregex_iterator at(text.begin(), text.end(), regex), end; at != end; ++at)
    found.push_back(at->str(1));
  return found;
}

std::string help(const std::string& command) {
  TemporaryFolder folder;
  return run_here({command, "--help"}, folder.path().string()).out;
}

std::vector<std::string> commands() {
  TemporaryFolder folder;
  return matches(run_here({"--help"}, folder.path().string()).out, R"(^  terrview \[?([a-z]+))");
}

// What the parser has, but for what every command has.
Names known_options(const std::string& command) {
  Names options;
  for (const std::string& names : matches(help(command), R"(^  (-\S+))"))
    for (const std::string& name : matches(names, "([^,]+)")) options.insert(name);
  for (const char* general : {"-h", "--help", "--version"}) options.erase(general);
  return options;
}

Names named_options(const std::string& text) {
  const auto found = matches(text, R"((?:^|[^\w-])(--[a-z][a-z-]*|-[a-z])(?![\w-]))");
  return {found.begin(), found.end()};
}

// From the line `heading` to the next one that begins as `next`.
std::string section(const std::string& text, const std::string& heading, const std::string& next) {
  const std::size_t begin = text.find("\n" + heading + "\n");
  if (begin == std::string::npos) return "";
  return text.substr(begin, text.find("\n" + next, begin + 1) - begin);
}

std::string cli_page(const std::string& command) {
  return section(read_text(TERRVIEW_SOURCE_DIR "/docs/cli.md"), "## " + command, "## ");
}

// Without its fonts and escapes.
std::string man_page(const std::string& command) {
  std::string upper;
  for (const char c : command) upper += static_cast<char>(std::toupper(c));
  const std::string page = section(read_text(TERRVIEW_MANUAL), ".SH " + upper, ".SH ");
  return std::regex_replace(std::regex_replace(page, std::regex(R"(\\f[BIR])"), ""),
                            std::regex(R"(\\-)"), "-");
}

TEST(Manual, HasASectionForEachCommand) {
  const std::vector<std::string> all = commands();
  EXPECT_GE(all.size(), 5U);
  for (const std::string& command : all) {
    EXPECT_NE(cli_page(command), "") << command;
    EXPECT_NE(man_page(command), "") << command;
  }
}

TEST(Manual, NamesTheOptionsOfHelpAndNoOthers) {
  for (const auto& page_of : {cli_page, man_page}) {
    for (const std::string& command : commands()) {
      SCOPED_TRACE(command);
      const Names known = known_options(command);
      ASSERT_GE(known.size(), 10U);
      const std::string page = page_of(command);
      Names documented = named_options(page);
      for (const std::string& name : documented)
        EXPECT_TRUE(known.contains(name)) << name << " is not an option";
      if (page.find("options of view") != std::string::npos)
        documented.merge(named_options(page_of("view")));
      for (const std::string& name : known)
        EXPECT_TRUE(documented.contains(name)) << name << " is not documented";
    }
  }
}

// As `man` shows it: nothing is lost, and no Markdown is left.
TEST(Manual, TheManPageIsTheWholePageInItsOwnMarkup) {
  const std::string page = read_text(TERRVIEW_MANUAL);
  EXPECT_EQ(page.rfind(".TH TERRVIEW 1 ", 0), 0U);
  for (const char* markup : {"`", "**", "](", "| ", "\n#"})
    EXPECT_EQ(page.find(markup), std::string::npos) << markup;
  EXPECT_NE(page.find("\n\\fB\\-\\-surface\\fR \\fIhyperboloid|band|triangles|bilinear\\fR\n"),
            std::string::npos);
  EXPECT_NE(page.find("Default: hyperboloid."), std::string::npos);
}

}  // namespace
}  // namespace terrview

// Promises of cli/batch/csv.h.
#include "cli/batch/csv.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "terrain/error.h"

namespace terrview {
namespace {

using Cells = std::vector<std::string>;

std::vector<Cells> cells_of(const std::string& text) {
  std::vector<Cells> all;
  for (const CsvRecord& record : parse_csv(text, "t.csv")) all.push_back(record.cells);
  return all;
}

// RFC 4180, every cell quoted.
std::string written(const std::vector<Cells>& records, const std::string& end_of_line) {
  std::string text;
  for (const Cells& cells : records) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      text += i > 0 ? ",\"" : "\"";
      for (const char c : cells[i]) text += c == '"' ? "\"\"" : std::string(1, c);
      text += '"';
    }
    text += end_of_line;
  }
  return text;
}

TEST(Csv, HasCellsWithCommasQuotesAndLines) {
  EXPECT_EQ(cells_of("name,eye\na,\"48,7,+2\"\n\"say \"\"so\"\"\",\"two\nlines\"\n"),
            (std::vector<Cells>{{"name", "eye"}, {"a", "48,7,+2"}, {"say \"so\"", "two\nlines"}}));
}

TEST(Csv, OfASpreadsheetIsRead) {
  const std::vector<Cells> expected{{"a", "b"}, {"1", ""}, {"", "2"}};
  EXPECT_EQ(cells_of("\xef\xbb\xbf"
                     "a,b\r\n1,\r\n\r\n,2"),
            expected);
  EXPECT_EQ(cells_of("a;b\r\n1;\r\n;2\r\n"), expected);
  EXPECT_EQ(cells_of("a\tb\n1\t\n\t2\n\n"), expected);
}

TEST(Csv, KnowsTheLineOfEachRecord) {
  const auto records = parse_csv("a,b\n\n\"x\ny\",1\nz,2\n", "t.csv");
  ASSERT_EQ(records.size(), 3U);
  EXPECT_EQ(records[1].line, 3);
  EXPECT_EQ(records[2].line, 5);
}

TEST(Csv, WithABrokenQuoteIsRefused) {
  for (const std::string text : {"a\n\"b", "a\n\"b\"c\n", "\"", "a,\"b\n"})
    EXPECT_THROW(static_cast<void>(parse_csv(text, "t.csv")), InputError) << text;
}

RC_GTEST_PROP(CsvProperty, WhatIsWrittenIsReadAgain, ()) {
  const auto cell =
      rc::gen::container<std::string>(rc::gen::elementOf(std::string("ab,;\t\"\n\r ")));
  const auto width = *rc::gen::inRange<std::size_t>(2, 5);
  const auto records =
      *rc::gen::container<std::vector<Cells>>(rc::gen::container<Cells>(width, cell));
  const std::string end_of_line = *rc::gen::elementOf(Cells{"\n", "\r\n"});
  // Commas are found as such in the first line.
  const Cells header(width, "h");
  std::vector<Cells> all{header};
  all.insert(all.end(), records.begin(), records.end());
  RC_ASSERT(cells_of(written(all, end_of_line)) == all);
}

}  // namespace
}  // namespace terrview

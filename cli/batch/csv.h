// Comma-separated values: RFC 4180, and what spreadsheets make of it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace terrview {

struct CsvRecord {
  int line;  // of its beginning, from 1
  std::vector<std::string> cells;
};

// UTF-8, with or without a byte order mark; lines end in LF or CRLF; blank lines are left out.
// Cells are parted by commas or, where the first line has none, by its semicolons or tabs. `name`
// is for messages. Throws InputError for a quote that is never closed, or text after a closing one.
[[nodiscard]] std::vector<CsvRecord> parse_csv(std::string_view text, const std::string& name);

// A cell as RFC 4180 has it.
[[nodiscard]] std::string csv_cell(const std::string& text);

}  // namespace terrview

// The table of a batch: one row a view.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace terrview {

struct JobRow {
  // By column. Several values only where the table can hold a list (JSON). Empty ones are left out.
  std::map<std::string, std::vector<std::string>> cells;
  std::string error;  // not empty: the row cannot be used

  // A cell's values as one text, parted by commas; empty = none.
  [[nodiscard]] std::string text(const std::string& column) const;
};

struct JobTable {
  std::vector<std::string> columns;  // of all rows, in order of appearance
  std::vector<JobRow> rows;
};

// `text` is CSV whose first line names the columns, a JSON array of objects, or a GeoJSON feature
// collection of points in WGS 84, whichever it looks like. A point's coordinates become the columns
// lat, lon and alt unless properties are called so. A row that has lat and lon but neither eye nor
// eye-xy gets an eye there, at alt or, without one, at +2. Numbers keep their shortest form, and
// objects are their JSON, which no option takes. `name` is for messages. Throws InputError for what
// is no table; a bad row only has an error.
[[nodiscard]] JobTable parse_job_table(std::string_view text, const std::string& name);

// Throws InputError also if the file cannot be read.
[[nodiscard]] JobTable read_job_table(const std::string& path);

}  // namespace terrview

// The options of `terrview batch`: docs/cli.md, one field each.
#pragma once

#include <string>
#include <vector>

#include "cli/batch/camera_path.h"
#include "cli/batch/option_values.h"
#include "cli/view_options.h"

namespace terrview {

struct BatchOptions {
  std::string table;
  std::string path;  // of a camera, instead of a table
  PathOptions moving;
  std::vector<std::string> dems;
  std::string manifest;  // empty: named after the table, beside the outputs
  std::string shard;     // as given
  bool resume = false;
  bool ignore_columns = false;
  bool shared_palette = false;
  std::vector<std::string> merge;
  ViewOptions view;     // of the command line alone
  OptionValues values;  // the same as texts

  // The file that the jobs come from.
  [[nodiscard]] const std::string& source() const { return path.empty() ? table : path; }
};

// Throws what CommandLine throws, and InputError.
[[nodiscard]] BatchOptions parse_batch(const std::vector<std::string>& args);

}  // namespace terrview

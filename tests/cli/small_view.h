// A folder with small DEMs, and views of them.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/cli/program.h"
#include "tests/ingest/test_raster.h"

namespace terrview {

using Arguments = std::vector<std::string>;

// The words of a command line parted by blanks.
[[nodiscard]] Arguments words(const std::string& line);
[[nodiscard]] Arguments operator+(Arguments first, const Arguments& second);

// The bands of a --layers .tif.
struct Layers {
  int width_px = 0;
  int height_px = 0;
  std::vector<std::string> names;
  std::vector<std::vector<double>> bands;

  [[nodiscard]] double at(const std::string& name, int column, int row) const;
};

class SmallView : public testing::Test {
 protected:
  // hills.tif: geographic, hills, 48 N 7 E in the middle; plain.asc: no CRS, 80 x 60 posts 10 m
  // apart from (0, 0), at 300 m.
  SmallView();

  // Within the test, and as a process of its own.
  [[nodiscard]] Finished run(const Arguments& args) const {
    return run_here(args, folder_.path().string());
  }
  [[nodiscard]] Finished run(const Arguments& args, const RunOptions& options) const {
    return run_program(args, folder_.path().string(), options);
  }

  // A quiet view of the hills, 64 x 48 pixels unless `args` say otherwise; must succeed.
  void view(const Arguments& args) const;
  void view(const std::string& line) const { view(words(line)); }

  [[nodiscard]] std::string path(const std::string& name) const { return folder_ / name; }
  [[nodiscard]] std::string bytes(const std::string& name) const { return read_text(path(name)); }
  [[nodiscard]] nlohmann::json json(const std::string& name) const;
  [[nodiscard]] Layers layers(const std::string& name) const;

  // Names in the folder, hidden ones too, but for the DEMs, in alphabetical order.
  [[nodiscard]] std::vector<std::string> outputs() const;

  TemporaryFolder folder_;
};

// The cells of each line, without quotes; commas within these part none.
using Rows = std::vector<std::vector<std::string>>;
[[nodiscard]] Rows csv_rows(const std::string& csv);

// The program has refused: exit code 2, one line with every one of `parts`, nothing else said.
void expect_refused(const Finished& finished, const std::vector<std::string>& parts);

}  // namespace terrview

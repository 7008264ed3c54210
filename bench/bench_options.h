// The command line of terrview-bench.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace terrview {

struct BenchOptions {
  std::vector<std::string> dems;  // files
  std::string json;               // outputs; empty = none
  std::string svg;
  std::string page;      // Markdown that is there, to fill in
  bool tremble = false;  // the study of surfaces instead
  bool light = false;    // the study of light and air instead
  std::string from;      // results to show instead of measuring
  // Of what there is, only these; empty = all.
  std::vector<std::string> scenes;      // synthetic, city, thesis, and the files' names
  std::vector<std::string> views;       // as in the results
  std::vector<std::string> rays;        // primary, shadow, file-to-png
  std::vector<std::string> contenders;  // names; '*' at the end stands for the rest
  std::vector<int> threads;             // empty = 1 and all
  int repetitions = 7;
  double budget_s = 3;
  int mountain_posts = 4096;
  int city_posts = 2048;
  glm::ivec2 size_px{1920, 1080};
};

// nullopt: help was asked for and given. Throws InputError.
[[nodiscard]] std::optional<BenchOptions> parse_bench_options(const std::vector<std::string>& args);

}  // namespace terrview

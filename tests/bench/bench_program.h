// One small run of terrview-bench, and what it wrote.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include <nlohmann/json.hpp>

#include "bench/bench_command.h"

namespace terrview {

[[nodiscard]] inline std::string text_of(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

// One run for all the tests: sizes that no tile divides, so that the edges of packets are tried.
class BenchProgram : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ =
        std::filesystem::temp_directory_path() / ("terrview_bench_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder_);
    testing::internal::CaptureStdout();
    const int code =
        run_bench({"--quick", "--posts", "65", "--size", "37x23", "--repetitions", "1", "--scenes",
                   "synthetic,city", "--json", (folder_ / "r.json").string(), "--svg",
                   (folder_ / "r.svg").string()});
    table_ = testing::internal::GetCapturedStdout();
    ASSERT_EQ(code, 0);
    run_ = nlohmann::ordered_json::parse(text_of(folder_ / "r.json"));
  }
  static void TearDownTestSuite() { std::filesystem::remove_all(folder_); }

  static std::set<std::string> values_of(const char* field) {
    std::set<std::string> values;
    for (const nlohmann::ordered_json& result : run_.at("results"))
      if (!result.at(field).is_null()) values.insert(result.at(field).get<std::string>());
    return values;
  }

  inline static std::filesystem::path folder_;
  inline static std::string table_;
  inline static nlohmann::ordered_json run_;
};

}  // namespace terrview

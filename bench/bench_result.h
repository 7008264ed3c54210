// One line of the benchmark, and the file that keeps them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace terrview {

struct BenchResult {
  std::string dem;
  std::string view;
  std::string rays;  // primary, shadow or file-to-png (both, and all that goes with them)
  std::string contender;
  int threads = 1;
  std::optional<std::string> surface;
  double mrays_per_s = 0;  // set-up of the rays, tracing, writing the frame; the median
  std::int64_t ray_count = 0;
  std::optional<double> hit_share;  // of the rays that meet ground, in the double reference
  std::optional<double> seconds;    // from file to PNG
  std::optional<double> tests_per_ray;
  std::optional<double> nodes_per_ray;
  std::optional<double> build_s;
  std::optional<double> memory_mib;
  std::optional<double> cells_differ;
  std::optional<std::int64_t> hit_flips;
  std::optional<double> p50_rel_error;
  std::optional<double> p99_rel_error;
  std::optional<double> max_rel_error;
};

struct BenchRun {
  nlohmann::ordered_json machine = nlohmann::ordered_json::object();
  std::string command;
  std::string date;  // ISO 8601, UTC
  std::vector<BenchResult> results;
};

// Whether both come from the same rays on the same threads.
[[nodiscard]] bool is_same_frame(const BenchResult& a, const BenchResult& b);

// The result of the same rays on the same threads by another contender; null if there is none.
[[nodiscard]] const BenchResult* beside(const std::vector<BenchResult>& results,
                                        const BenchResult& one, const std::string& contender);

// What does not apply is null.
[[nodiscard]] nlohmann::ordered_json to_json(const BenchRun& run);

// Throws nlohmann::json::exception for JSON of another shape.
[[nodiscard]] BenchRun run_from_json(const nlohmann::ordered_json& json);

}  // namespace terrview

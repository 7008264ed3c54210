// GDAL made fit for a library: its drivers registered, its messages kept instead of printed, code
// in files never run.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace terrview {

// Lets GDAL keep no more than `bytes` of files' blocks from now on. GDAL_CACHEMAX has the last
// word.
void limit_block_cache(std::int64_t bytes);

// While one lives, what GDAL reports in this thread is collected here. They nest.
class GdalScope {
 public:
  GdalScope();
  ~GdalScope();
  GdalScope(const GdalScope&) = delete;
  GdalScope& operator=(const GdalScope&) = delete;

  // The first failure since the last call, in one line; empty = none.
  [[nodiscard]] std::string take_failure();

  // Throws std::runtime_error with that.
  [[noreturn]] void throw_failure();

  // The different warnings since the last call, one line each.
  [[nodiscard]] std::vector<std::string> take_warnings();

 private:
  static void collect(int severity, int number, const char* text);

  std::vector<std::string> failures_;
  std::vector<std::string> warnings_;
  std::vector<std::optional<std::string>> settings_before_;
};

}  // namespace terrview

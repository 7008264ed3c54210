// The program, run as a user runs it, and its command line within the test (a tenth of the time).
#pragma once

#include <sys/resource.h>
#include <sys/types.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tests/support/temporary_folder.h"

namespace terrview {

struct Finished {
  int exit_code;  // 128 + the signal that ended it
  std::string out;
  std::string err;
};

struct RunOptions {
  std::optional<int> ignored_signal = {};
  bool unread_messages = false;  // standard error is a pipe that nobody reads
  unsigned patience_s = 120;     // then it hangs, and is killed
};

class Program {
 public:
  // Starts it in `folder`.
  Program(const std::vector<std::string>& args, const std::string& folder,
          const RunOptions& options = {});
  ~Program();  // ends it
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void send(int signal) const;
  [[nodiscard]] Finished wait();

 private:
  [[noreturn]] void become(const std::vector<std::string>& args, const std::string& folder,
                           const RunOptions& options) const;

  TemporaryFolder streams_;
  pid_t pid_ = -1;
};

// No file may grow beyond `bytes` while this lives: for whoever writes, a full disk.
class FullDisk {
 public:
  explicit FullDisk(std::uint64_t bytes);
  ~FullDisk();
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  rlimit before_{};
};

// terrview::run() in `folder`.
[[nodiscard]] Finished run_here(const std::vector<std::string>& args, const std::string& folder);

[[nodiscard]] Finished run_program(const std::vector<std::string>& args, const std::string& folder,
                                   const RunOptions& options = {});

}  // namespace terrview

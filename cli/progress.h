// A progress bar on standard error, in the manner of GDAL's.
#pragma once

#include <functional>
#include <mutex>
#include <string>

namespace terrview {

class ProgressBar {
 public:
  // `shown` false makes it silent. Nothing is drawn before a second has passed.
  ProgressBar(std::string label, bool shown);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  // From any thread; shares may come out of order.
  void report(double share);

 private:
  std::string label_;
  bool shown_;
  double start_s_;
  std::mutex mutex_;
  int drawn_percent_ = -1;
};

// parallel_for() that shows how far it is and can be interrupted.
void parallel_for(int count, int threads, ProgressBar& bar,
                  const std::function<void(int index)>& work);

// Whether standard error is a terminal.
[[nodiscard]] bool stderr_is_terminal();

}  // namespace terrview

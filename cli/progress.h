// A progress bar on standard error, in the manner of GDAL's.
#pragma once

#include <functional>
#include <mutex>
#include <string>

namespace terrview {

enum class ShowBar {
  never,
  for_long_work,  // once a second has passed
  always,
};

// `asked` is --progress; unasked, a bar is for terminals.
[[nodiscard]] ShowBar show_bar(bool quiet, bool asked);

class ProgressBar {
 public:
  ProgressBar(std::string label, ShowBar show);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  // From any thread; shares may come out of order.
  void report(double share);

 private:
  std::string label_;
  ShowBar show_;
  double start_s_;
  std::mutex mutex_;
  int drawn_percent_ = -1;
};

// parallel_for() that shows how far it is and can be interrupted.
void parallel_for(int count, int threads, ProgressBar& bar,
                  const std::function<void(int index)>& work);

}  // namespace terrview

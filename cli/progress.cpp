#include "cli/progress.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <utility>

#include "cli/interrupt.h"
#include "render/parallel.h"

namespace terrview {
namespace {

constexpr double kQuiet_s = 1;  // shorter work needs no bar
constexpr int kWidth = 30;

double now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

ShowBar show_bar(bool quiet, bool asked) {
  if (quiet) return ShowBar::never;
  if (asked) return ShowBar::always;
  return ::isatty(STDERR_FILENO) == 1 ? ShowBar::for_long_work : ShowBar::never;
}

ProgressBar::ProgressBar(std::string label, ShowBar show)
    : label_(std::move(label)), show_(show), start_s_(now_s()) {}

ProgressBar::~ProgressBar() {
  if (drawn_percent_ >= 0) std::fputc('\n', stderr);
}

void ProgressBar::report(double share) {
  if (show_ == ShowBar::never) return;
  if (show_ == ShowBar::for_long_work && now_s() - start_s_ < kQuiet_s) return;
  const int percent = static_cast<int>(std::clamp(share, 0.0, 1.0) * 100);
  const std::lock_guard lock(mutex_);
  if (percent <= drawn_percent_) return;
  drawn_percent_ = percent;
  const int filled = percent * kWidth / 100;
  const double spent_s = now_s() - start_s_;
  const double left_s = share > 0 ? spent_s * (1 - share) / share : 0;
  std::fprintf(stderr, "\r%s [%s%s] %3d %% %4.0f s left ", label_.c_str(),
               std::string(static_cast<std::size_t>(filled), '#').c_str(),
               std::string(static_cast<std::size_t>(kWidth - filled), ' ').c_str(), percent,
               left_s);
  std::fflush(stderr);
}

void parallel_for(int count, int threads, ProgressBar& bar, const std::function<void(int)>& work) {
  std::atomic<int> done = 0;
  parallel_for(count, threads, [&](int index) {
    check_interrupt();
    work(index);
    bar.report(static_cast<double>(++done) / count);
  });
}

}  // namespace terrview

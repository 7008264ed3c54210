// Times contenders on the same rays, in turns, and compares what they write with the reference.
// One thread is timed by its processor time, several by the wall clock.
#pragma once

#include <string>
#include <vector>

#include "bench/bench_result.h"
#include "bench/contender.h"

namespace terrview {

struct MeasureOptions {
  std::vector<std::string> rays;  // primary, shadow; empty = both
  std::vector<int> threads{1};
  int repetitions = 5;  // medians are taken of these
  double budget_s = 3;  // a contender that has spent more sits out the repetitions left
};

// Primary rays, and shadow rays from the ground that the reference of each surface shows.
[[nodiscard]] std::vector<BenchResult> measure(const BenchDem& dem, const BenchView& view,
                                               const std::vector<Contender>& contenders,
                                               const MeasureOptions& options);

}  // namespace terrview

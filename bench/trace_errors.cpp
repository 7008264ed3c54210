#include "bench/trace_errors.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <vector>

namespace terrview {
namespace {

// The value that `share` of the values do not exceed.
double percentile(std::vector<double>& values, double share) {
  if (values.empty()) return 0;
  const auto last = static_cast<double>(values.size() - 1);
  const auto nth = values.begin() + static_cast<std::ptrdiff_t>(std::ceil(share * last));
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

}  // namespace

TraceErrors trace_errors(const TracedFrame& reference, const TracedFrame& frame) {
  assert(reference.size_px == frame.size_px);
  std::int64_t hit_flips = 0;
  std::int64_t other_cells = 0;
  std::vector<double> errors;
  for (std::size_t i = 0; i < frame.pixels(); ++i) {
    const bool expected = reference.cell[i] != kNoCell;
    if (expected != (frame.cell[i] != kNoCell)) ++hit_flips;
    if (!expected || frame.cell[i] == kNoCell) continue;
    if (frame.cell[i] != reference.cell[i]) ++other_cells;
    errors.push_back(std::abs(frame.distance_m[i] - reference.distance_m[i]) /
                     reference.distance_m[i]);
  }
  const auto both = static_cast<double>(std::max<std::size_t>(1, errors.size()));
  return {.hit_flips = hit_flips,
          .cells_differ = static_cast<double>(other_cells) / both,
          .p50_rel_error = percentile(errors, 0.5),
          .p99_rel_error = percentile(errors, 0.99),
          .max_rel_error = percentile(errors, 1)};
}

std::int64_t shadow_flips(const ShadowFrame& reference, const ShadowFrame& frame) {
  assert(reference.size() == frame.size());
  std::int64_t flips = 0;
  for (std::size_t i = 0; i < frame.size(); ++i) flips += reference[i] != frame[i] ? 1 : 0;
  return flips;
}

}  // namespace terrview

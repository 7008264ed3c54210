// How far a frame is from the double-precision reference of its own surface.
#pragma once

#include <cstdint>

#include "bench/traced_frame.h"

namespace terrview {

struct TraceErrors {
  std::int64_t hit_flips;  // pixels that miss a hit, or invent one
  // Of the pixels where both hit; 0 where there are none.
  double cells_differ;  // share whose cell is another
  // |distance - reference| / reference
  double p50_rel_error;
  double p99_rel_error;
  double max_rel_error;
};

// Both frames have the same size.
[[nodiscard]] TraceErrors trace_errors(const TracedFrame& reference, const TracedFrame& frame);

// Pixels that differ.
[[nodiscard]] std::int64_t shadow_flips(const ShadowFrame& reference, const ShadowFrame& frame);

}  // namespace terrview

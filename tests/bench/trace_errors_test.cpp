// One test per promise in bench/trace_errors.h.
#include "bench/trace_errors.h"

#include <gtest/gtest.h>

namespace terrview {
namespace {

// 100 pixels, all on one cell, at 1, 2, ... 100 m.
TracedFrame hundred_hits() {
  TracedFrame frame({100, 1});
  for (std::size_t i = 0; i < 100; ++i) {
    frame.distance_m[i] = static_cast<double>(i + 1);
    frame.cell[i] = 7;
  }
  return frame;
}

TEST(TraceErrors, AFrameIsEqualToItself) {
  const TraceErrors errors = trace_errors(hundred_hits(), hundred_hits());
  EXPECT_EQ(errors.hit_flips, 0);
  EXPECT_EQ(errors.cells_differ, 0);
  EXPECT_EQ(errors.max_rel_error, 0);
}

TEST(TraceErrors, MissedAndInventedHitsAreFlipsAndCountForNothingElse) {
  TracedFrame reference = hundred_hits();
  TracedFrame frame = hundred_hits();
  reference.cell[3] = kNoCell;  // invented
  frame.cell[4] = kNoCell;      // missed
  frame.distance_m[4] = 1e9;
  const TraceErrors errors = trace_errors(reference, frame);
  EXPECT_EQ(errors.hit_flips, 2);
  EXPECT_EQ(errors.cells_differ, 0);
  EXPECT_EQ(errors.max_rel_error, 0);
}

TEST(TraceErrors, CellsAreComparedWhereBothHit) {
  TracedFrame frame = hundred_hits();
  for (std::size_t i = 0; i < 25; ++i) frame.cell[i] = 8;
  for (std::size_t i = 50; i < 100; ++i) frame.cell[i] = kNoCell;
  EXPECT_EQ(trace_errors(hundred_hits(), frame).cells_differ, 0.5);
}

TEST(TraceErrors, DistancesAreComparedByTheirShareOfTheReference) {
  TracedFrame frame = hundred_hits();
  for (std::size_t i = 0; i < 100; ++i)
    frame.distance_m[i] *= 1 + static_cast<double>(i) * 0x1p-10;  // 0, 1, ... 99 parts of 1024
  const TraceErrors errors = trace_errors(hundred_hits(), frame);
  EXPECT_NEAR(errors.p50_rel_error, 50 * 0x1p-10, 1e-12);
  EXPECT_NEAR(errors.p99_rel_error, 99 * 0x1p-10, 1e-12);
  EXPECT_NEAR(errors.max_rel_error, 99 * 0x1p-10, 1e-12);
}

TEST(TraceErrors, WhereNothingIsHitThereIsNoError) {
  TracedFrame nothing({4, 4});
  nothing.clear();
  const TraceErrors errors = trace_errors(nothing, nothing);
  EXPECT_EQ(errors.hit_flips, 0);
  EXPECT_EQ(errors.max_rel_error, 0);
}

TEST(ShadowFlips, CountsThePixelsThatDiffer) {
  EXPECT_EQ(shadow_flips({0, 1, 1, 0}, {0, 1, 0, 1}), 2);
}

}  // namespace
}  // namespace terrview

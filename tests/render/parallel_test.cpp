// One test per promise of render/parallel.h.
#include "render/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace terrview {
namespace {

TEST(ParallelFor, CallsTheWorkOnceForEachIndex) {
  for (const int threads : {0, 1, 3, 16}) {
    std::vector<std::atomic<int>> calls(500);
    parallel_for(500, threads, [&](int index) { ++calls[static_cast<std::size_t>(index)]; });
    for (const auto& count : calls) ASSERT_EQ(count, 1) << threads;
  }
}

TEST(ParallelFor, DoesNothingForNone) {
  parallel_for(0, 2, [](int index) { ADD_FAILURE() << index; });
}

TEST(ParallelFor, ThrowsWhatTheWorkThrows) {
  const auto work = [](int index) {
    if (index == 250) throw std::domain_error("250");
  };
  for (const int threads : {1, 3})
    EXPECT_THROW(parallel_for(500, threads, work), std::domain_error);
}

}  // namespace
}  // namespace terrview

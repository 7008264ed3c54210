// The one place that starts threads.
#pragma once

#include <functional>

namespace terrview {

// Calls work(0) ... work(count - 1), each once, in any order on up to `threads` threads (0 = all).
// What a call throws ends the loop and is thrown again.
void parallel_for(int count, int threads, const std::function<void(int index)>& work);

// Calls work() on each of `count` threads of their own, which may call parallel_for(), and waits
// for all of them. Throws what the first of them threw.
void run_workers(int count, const std::function<void()>& work);

}  // namespace terrview

#include "render/parallel.h"

#include <cstddef>
#include <exception>
#include <optional>
#include <thread>
#include <vector>

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace terrview {

void parallel_for(int count, int threads, const std::function<void(int index)>& work) {
  // Without this oneTBB keeps to the cores there are, and complains on standard error.
  std::optional<tbb::global_control> allowed;
  if (threads > tbb::info::default_concurrency())
    allowed.emplace(tbb::global_control::max_allowed_parallelism,
                    static_cast<std::size_t>(threads));
  tbb::task_arena arena(threads > 0 ? threads : tbb::task_arena::automatic);
  arena.execute([&] { tbb::parallel_for(0, count, [&](int index) { work(index); }); });
}

void run_workers(int count, const std::function<void()>& work) {
  std::vector<std::thread> workers;
  std::vector<std::exception_ptr> thrown(static_cast<std::size_t>(count));
  for (std::exception_ptr& error : thrown) {
    workers.emplace_back([&work, &error] {
      try {
        work();
      } catch (...) {
        error = std::current_exception();
      }
    });
  }
  for (std::thread& worker : workers) worker.join();
  for (const std::exception_ptr& error : thrown)
    if (error) std::rethrow_exception(error);
}

}  // namespace terrview

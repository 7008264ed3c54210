#include "render/parallel.h"

#include <cstddef>
#include <optional>

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace terrview {

void parallel_for(int count, int threads, const std::function<void(int index)>& work) {
  // Without this oneTBB keeps to the cores there are, and complains on standard error.
  std::optional<tbb::global_control> allowed;
  if (threads > 0)
    allowed.emplace(tbb::global_control::max_allowed_parallelism,
                    static_cast<std::size_t>(threads));
  tbb::task_arena arena(threads > 0 ? threads : tbb::task_arena::automatic);
  arena.execute([&] { tbb::parallel_for(0, count, [&](int index) { work(index); }); });
}

}  // namespace terrview

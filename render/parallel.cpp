#include "render/parallel.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace terrview {

void parallel_for(int count, int threads, const std::function<void(int index)>& work) {
  tbb::task_arena arena(threads > 0 ? threads : tbb::task_arena::automatic);
  arena.execute([&] { tbb::parallel_for(0, count, [&](int index) { work(index); }); });
}

}  // namespace terrview

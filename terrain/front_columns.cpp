#include <algorithm>
#include <cstddef>
#include <memory>

#include "terrain/column_tracer.h"
#include "terrain/eye_tracer.h"

namespace terrview {
namespace {

void aim(const ColumnView& view, std::size_t first, std::size_t row, EyeRays& rays) {
  for (std::size_t i = 0; i < rays.count; ++i)
    rays.aim(i, {view.across[first + i], view.rise[row]});
}

}  // namespace

void trace_columns(const EyeFront& front, const ColumnView& view, int first, int count,
                   std::span<ColumnHit> hits, TraceCounts& counts) {
  const auto rays = std::make_unique<EyeRays>();
  const std::size_t rows = view.rise.size();
  const auto columns = static_cast<std::size_t>(count);
  for (std::size_t done = 0; done < columns; done += EyeRays::kMost) {
    rays->count = std::min(EyeRays::kMost, columns - done);
    rays->begin_to_follow();
    for (std::size_t row = rows; row-- > 0;) {
      aim(view, static_cast<std::size_t>(first) + done, row, *rays);
      trace(front, *rays, counts);
      for (std::size_t i = 0; i < rays->count; ++i) {
        if (!rays->is_hit(i)) continue;
        const glm::ivec2 cell(static_cast<int>(rays->column[i]), static_cast<int>(rays->row[i]));
        hits[(done + i) * rows + row] = {rays->ground_m[i], {rays->u[i], rays->v[i]}, cell};
      }
    }
  }
}

}  // namespace terrview

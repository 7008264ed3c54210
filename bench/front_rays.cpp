#include "bench/front_rays.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>

#include "render/parallel.h"
#include "terrain/eye_tracer.h"

namespace terrview {

FrameWork trace_front(const EyeFront& front, const Camera& camera, int threads,
                      TracedFrame& frame) {
  constexpr int kWide_px = 32;
  constexpr int kHigh_px = static_cast<int>(EyeRays::kMost) / kWide_px;
  std::atomic<std::int64_t> tests = 0;
  std::atomic<std::int64_t> nodes = 0;
  const glm::ivec2 size_px = frame.size_px;
  const int cells_in_row = front.terrain().layers()[0].grid->columns - 1;
  parallel_for((size_px.y + kHigh_px - 1) / kHigh_px, threads, [&](int band) {
    const auto rays = std::make_unique<EyeRays>();
    const auto normals = std::make_unique<EyeNormals>();
    TraceCounts counts;
    const int rows = std::min(kHigh_px, size_px.y - band * kHigh_px);
    for (int left = 0; left < size_px.x; left += kWide_px) {
      const int columns = std::min(kWide_px, size_px.x - left);
      std::size_t i = 0;
      for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column, ++i) {
          rays->aim(i, camera.ray({left + column + 0.5, band * kHigh_px + row + 0.5}).direction);
        }
      rays->count = i;
      trace(front, *rays, counts);
      facet_normals(front.terrain(), *rays, *normals);
      i = 0;
      for (int row = 0; row < rows; ++row) {
        std::size_t pixel = frame.index(left, band * kHigh_px + row);
        for (int column = 0; column < columns; ++column, ++i, ++pixel) {
          const bool hit = rays->is_hit(i);
          frame.distance_m[pixel] =
              hit ? rays->distance_m(i) : std::numeric_limits<double>::infinity();
          frame.cell[pixel] = hit ? static_cast<std::int32_t>(rays->row[i]) * cells_in_row +
                                        static_cast<std::int32_t>(rays->column[i])
                                  : kNoCell;
          frame.normal_east[pixel] = hit ? static_cast<float>(normals->x[i]) : 0;
          frame.normal_north[pixel] = hit ? static_cast<float>(normals->y[i]) : 0;
        }
      }
    }
    tests += counts.tests;
    nodes += counts.nodes;
  });
  return {.tests = tests, .nodes = nodes};
}

}  // namespace terrview

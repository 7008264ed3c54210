#include "bench/front_rays.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "render/parallel.h"
#include "terrain/eye_tracer.h"

namespace terrview {

namespace {

// Of a row of pixels, from `first` on.
void store_row(const EyeFacets& facets, std::size_t first, std::size_t count, TracedFrame& frame,
               std::size_t pixel) {
  std::copy_n(facets.distance_m.data() + first, count, frame.distance_m.data() + pixel);
  std::copy_n(facets.cell.data() + first, count, frame.cell.data() + pixel);
  std::copy_n(facets.x.data() + first, count, frame.normal_east.data() + pixel);
  std::copy_n(facets.y.data() + first, count, frame.normal_north.data() + pixel);
}

}  // namespace

FrameWork trace_front(const EyeFront& front, const Camera& camera, int threads,
                      TracedFrame& frame) {
  constexpr int kWide_px = 32;
  constexpr int kHigh_px = static_cast<int>(EyeRays::kMost) / kWide_px;
  std::atomic<std::int64_t> tests = 0;
  std::atomic<std::int64_t> nodes = 0;
  const glm::ivec2 size_px = frame.size_px;
  parallel_for((size_px.y + kHigh_px - 1) / kHigh_px, threads, [&](int band) {
    const auto rays = std::make_unique<EyeRays>();
    const auto seen = std::make_unique<EyeFacets>();
    TraceCounts counts;
    const int rows = std::min(kHigh_px, size_px.y - band * kHigh_px);
    for (int left = 0; left < size_px.x; left += kWide_px) {
      const int columns = std::min(kWide_px, size_px.x - left);
      std::size_t i = 0;
      const auto width = static_cast<std::size_t>(columns);
      for (int row = 0; row < rows; ++row, i += width)
        camera.aim_row({left + 0.5, band * kHigh_px + row + 0.5},
                       {std::span(rays->direction_x).subspan(i, width),
                        std::span(rays->direction_y).subspan(i, width),
                        std::span(rays->direction_z).subspan(i, width)});
      rays->count = i;
      trace(front, *rays, counts);
      facets(front.terrain(), *rays, *seen);
      for (int row = 0; row < rows; ++row)
        store_row(*seen, static_cast<std::size_t>(row) * width, width, frame,
                  frame.index(left, band * kHigh_px + row));
    }
    tests += counts.tests;
    nodes += counts.nodes;
  });
  return {.tests = tests, .nodes = nodes};
}

}  // namespace terrview

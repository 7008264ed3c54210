#include "bench/front_rays.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>

#include "render/parallel.h"
#include "terrain/eye_tracer.h"

namespace terrview {

namespace {

struct Row {
  std::size_t first;
  std::size_t count;
  int cells_in_row;
};

// Loop by loop, so that the compiler may make vectors of each.
void store_row(const EyeRays& rays, const EyeNormals& normals, const Row& row, TracedFrame& frame,
               std::size_t pixel) {
  const double* ground_m = rays.ground_m.data() + row.first;
  const double* slope = rays.slope.data() + row.first;
  double* distance_m = frame.distance_m.data() + pixel;
  for (std::size_t i = 0; i < row.count; ++i) {
    const double along = std::isinf(slope[i]) ? 1 : std::sqrt(1 + slope[i] * slope[i]);
    distance_m[i] = ground_m[i] < 0 ? std::numeric_limits<double>::infinity() : ground_m[i] * along;
  }
  const double* cell_row = rays.row.data() + row.first;
  const double* cell_column = rays.column.data() + row.first;
  std::int32_t* cell = frame.cell.data() + pixel;
  for (std::size_t i = 0; i < row.count; ++i) {
    const bool hit = ground_m[i] >= 0;
    const double index = hit ? cell_row[i] * row.cells_in_row + cell_column[i] : kNoCell;
    cell[i] = static_cast<std::int32_t>(index);
  }
  const auto store_normal = [&](const double* from, float* to) {
    for (std::size_t i = 0; i < row.count; ++i)
      to[i] = ground_m[i] >= 0 ? static_cast<float>(from[i]) : 0;
  };
  store_normal(normals.x.data() + row.first, frame.normal_east.data() + pixel);
  store_normal(normals.y.data() + row.first, frame.normal_north.data() + pixel);
}

}  // namespace

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
      const auto width = static_cast<std::size_t>(columns);
      for (int row = 0; row < rows; ++row, i += width)
        camera.aim_row({left + 0.5, band * kHigh_px + row + 0.5},
                       {std::span(rays->direction_x).subspan(i, width),
                        std::span(rays->direction_y).subspan(i, width),
                        std::span(rays->direction_z).subspan(i, width)});
      rays->count = i;
      trace(front, *rays, counts);
      facet_normals(front.terrain(), *rays, *normals);
      for (int row = 0; row < rows; ++row)
        store_row(*rays, *normals, {static_cast<std::size_t>(row) * width, width, cells_in_row},
                  frame, frame.index(left, band * kHigh_px + row));
    }
    tests += counts.tests;
    nodes += counts.nodes;
  });
  return {.tests = tests, .nodes = nodes};
}

}  // namespace terrview

#include <cstddef>

#include "bench/contender.h"
#include "bench/plain.h"
#include "render/parallel.h"

namespace terrview {
namespace {

Contender plain(SurfaceModel surface) {
  return {.name = "terrview-plain",
          .surface = surface,
          .build_s = {},
          .memory_mib = {},
          .primary =
              [surface](const BenchScene& scene, int threads, TracedFrame& frame) {
                return trace_plain(scene.terrains.at(surface), scene.view.camera, threads, frame);
              },
          .shadow =
              [surface](const BenchScene& scene, const ShadowRays& rays, int threads,
                        ShadowFrame& frame) {
                return shade_plain(scene.terrains.at(surface), scene.view, rays, threads, frame);
              }};
}

// No frame can be traced faster than it is written.
FrameWork write_frame(int threads, TracedFrame& frame) {
  parallel_rows(frame.size_px.y, threads, [&](int row) {
    const std::size_t end = frame.index(0, row + 1);
    for (std::size_t i = frame.index(0, row); i < end; ++i) {
      frame.distance_m[i] = row;
      frame.cell[i] = row;
      frame.normal_east[i] = 0;
      frame.normal_north[i] = 0;
    }
  });
  return {};
}

Contender frame_writer() {
  return {.name = "write-frame",
          .surface = {},
          .build_s = {},
          .memory_mib = {},
          .primary = [](const BenchScene& /*scene*/, int threads,
                        TracedFrame& frame) { return write_frame(threads, frame); },
          .shadow = {}};
}

}  // namespace

std::vector<Contender> terrview_contenders(const BenchDem& /*dem*/) {
  return {frame_writer(), plain(SurfaceModel::hyperboloid), plain(SurfaceModel::triangles),
          plain(SurfaceModel::bilinear)};
}

}  // namespace terrview

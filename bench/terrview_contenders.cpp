#include <chrono>
#include <cmath>
#include <cstddef>
#include <memory>

#include "bench/contender.h"
#include "bench/scalar_rays.h"
#include "render/parallel.h"
#include "terrain/height_pyramid.h"

namespace terrview {
namespace {

struct Method {
  const char* name;
  Search search;
};

// Rays one by one, scalar, in double precision.
Contender scalar(const BenchDem& dem, const Method& method, SurfaceModel surface) {
  const auto place = [&dem, method, surface](const BenchView& view) -> ViewTracer {
    const auto terrain =
        std::make_shared<const Terrain>(terrain_of(dem, view, surface, method.search));
    return {.primary =
                [terrain, &view](int threads, TracedFrame& frame) {
                  return trace_rays(*terrain, view.camera, threads, frame);
                },
            .shadow =
                [terrain, &view](const ShadowRays& rays, int threads, ShadowFrame& frame) {
                  return shade_rays(*terrain, view, rays, threads, frame);
                }};
  };
  return {.name = method.name, .surface = surface, .build_s = {}, .memory_mib = {}, .place = place};
}

struct Built {
  double seconds;
  double mib;
};

Built build_pyramid(const HeightGrid& grid) {
  const auto start = std::chrono::steady_clock::now();
  const HeightPyramid pyramid(grid);
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
  double blocks = 0;
  for (int level = HeightPyramid::kFirstLevel; level <= pyramid.last_level(); ++level)
    blocks += std::ceil(std::ldexp(grid.columns - 1, -level)) *
              std::ceil(std::ldexp(grid.rows - 1, -level));
  return {spent.count(), blocks * sizeof(HeightPyramid::Range) / (1 << 20)};
}

// No frame can be traced faster than it is written.
FrameWork write_frame(int threads, TracedFrame& frame) {
  parallel_for(frame.size_px.y, threads, [&](int row) {
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
  const auto place = [](const BenchView& /*view*/) -> ViewTracer {
    return {.primary = write_frame, .shadow = {}};
  };
  return {.name = "write-frame", .surface = {}, .build_s = {}, .memory_mib = {}, .place = place};
}

}  // namespace

std::vector<Contender> terrview_contenders(const BenchDem& dem) {
  const Built pyramid = build_pyramid(*dem.grid);
  std::vector<Contender> contenders{frame_writer()};
  for (const SurfaceModel surface :
       {SurfaceModel::hyperboloid, SurfaceModel::triangles, SurfaceModel::bilinear}) {
    contenders.push_back(scalar(dem, {"terrview-plain", Search::plain}, surface));
    contenders.push_back(scalar(dem, {"terrview-pyramid", Search::pyramid}, surface));
    contenders.back().build_s = pyramid.seconds;
    contenders.back().memory_mib = pyramid.mib;
  }
  return contenders;
}

}  // namespace terrview

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>

#include "bench/contender.h"
#include "bench/scalar_rays.h"
#include "render/parallel.h"
#include "terrain/column_tracer.h"
#include "terrain/eye_tracer.h"
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

// Columns of the image that are vertical planes, in strips; as the renderer takes them.
FrameWork trace_strips(const Terrain& terrain, const ColumnView& view, int threads,
                       TracedFrame& frame) {
  constexpr int kStrip_px = 16;
  std::atomic<std::int64_t> tests = 0;
  std::atomic<std::int64_t> nodes = 0;
  const glm::ivec2 size_px = frame.size_px;
  parallel_for((size_px.x + kStrip_px - 1) / kStrip_px, threads, [&](int strip) {
    const int first = strip * kStrip_px;
    const int count = std::min(kStrip_px, size_px.x - first);
    std::vector<ColumnHit> hits(static_cast<std::size_t>(count) *
                                static_cast<std::size_t>(size_px.y));
    TraceCounts counts;
    trace_columns(terrain, view, first, count, hits, counts);
    auto hit = hits.begin();
    for (int column = first; column < first + count; ++column)
      for (int row = 0; row < size_px.y; ++row, ++hit)
        store(hit->g_m < 0 ? std::nullopt : std::optional(column_hit(view, column, row, *hit)),
              terrain, frame, frame.index(column, row));
    tests += counts.tests;
    nodes += counts.nodes;
  });
  return {.tests = tests, .nodes = nodes};
}

// Rays in blocks of the image, by the view's front; as the renderer takes them.
FrameWork trace_blocks(const EyeFront& front, const Camera& camera, int threads,
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
          const Ray ray = camera.ray({left + column + 0.5, band * kHigh_px + row + 0.5});
          rays->direction_x[i] = ray.direction.x;
          rays->direction_y[i] = ray.direction.y;
          rays->direction_z[i] = ray.direction.z;
        }
      rays->count = i;
      trace(front, *rays, counts);
      facet_normals(front.terrain(), *rays, *normals);
      i = 0;
      for (int row = 0; row < rows; ++row) {
        std::size_t pixel = frame.index(left, band * kHigh_px + row);
        for (int column = 0; column < columns; ++column, ++i, ++pixel) {
          const bool hit = rays->is_hit(i);
          frame.distance_m[pixel] = hit ? rays->ground_m[i] * std::sqrt(1 + rays->slope[i] * rays->slope[i])
                                        : std::numeric_limits<double>::infinity();
          frame.cell[pixel] =
              hit ? static_cast<std::int32_t>(rays->row[i]) * cells_in_row + static_cast<std::int32_t>(rays->column[i]) : kNoCell;
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

Contender by_front(const BenchDem& dem) {
  Contender contender = scalar(dem, {"terrview-front", Search::pyramid}, SurfaceModel::hyperboloid);
  const auto ceilings = std::make_shared<const HeightCeilings>(*dem.grid);
  contender.place = [&dem, ceilings, scalar_place = contender.place](const BenchView& view) {
    ViewTracer tracer = scalar_place(view);
    const auto terrain = std::make_shared<const Terrain>(
        terrain_of(dem, view, SurfaceModel::hyperboloid, Search::pyramid));
    tracer.primary = [terrain, ceilings, &view](int threads, TracedFrame& frame) {
        static const double px = getenv("WPX") ? atof(getenv("WPX")) : 4.0;
        const EyeFront front(*terrain, *ceilings, EyeFrontOptions{.wedge_rad = px * view.camera.options().fov_rad / view.camera.options().size_px.x});
        return trace_blocks(front, view.camera, threads, frame);
      };
    tracer.shadow = {};
    return tracer;
  };
  return contender;
}

// The way the program goes by default.
Contender default_way(const BenchDem& dem) {
  Contender contender = scalar(dem, {"terrview", Search::pyramid}, SurfaceModel::hyperboloid);
  contender.place = [&dem, scalar_place = contender.place](const BenchView& view) {
    ViewTracer tracer = scalar_place(view);
    const auto terrain = std::make_shared<const Terrain>(
        terrain_of(dem, view, SurfaceModel::hyperboloid, Search::pyramid));
    const auto columns = column_view(view.camera);
    if (columns && has_columns(*terrain))
      tracer.primary = [terrain, columns = *columns](int threads, TracedFrame& frame) {
        return trace_strips(*terrain, columns, threads, frame);
      };
    return tracer;
  };
  return contender;
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
  const auto add_built = [&](Contender contender) {
    contender.build_s = pyramid.seconds;
    contender.memory_mib = pyramid.mib;
    contenders.push_back(std::move(contender));
  };
  add_built(default_way(dem));
  add_built(by_front(dem));
  for (const SurfaceModel surface :
       {SurfaceModel::hyperboloid, SurfaceModel::triangles, SurfaceModel::bilinear}) {
    contenders.push_back(scalar(dem, {"terrview-plain", Search::plain}, surface));
    add_built(scalar(dem, {"terrview-pyramid", Search::pyramid}, surface));
  }
  return contenders;
}

}  // namespace terrview

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "bench/contender.h"
#include "bench/front_rays.h"
#include "bench/scalar_rays.h"
#include "render/neighbour_tracer.h"
#include "render/parallel.h"
#include "render/pixel_lattice.h"
#include "render/view_front.h"
#include "terrain/column_tracer.h"
#include "terrain/height_ceilings.h"

namespace terrview {
namespace {

struct Method {
  const char* name;
  SurfaceModel surface;
  Search search;
  BenchEarth earth = BenchEarth::flat;
};

// Rays one by one, scalar, in double precision.
Contender scalar(const BenchDem& dem, const Method& method) {
  const auto place = [&dem, method](const BenchView& view) -> ViewTracer {
    const auto terrain = terrain_on(method.earth, dem, view, method.surface, method.search);
    return {.primary =
                [terrain, &view](int threads, TracedFrame& frame) {
                  return trace_rays(*terrain, view.camera, threads, frame);
                },
            .shadow =
                [terrain, &view](const ShadowRays& rays, int threads, ShadowFrame& frame) {
                  return shade_rays(*terrain, view, nullptr, rays, threads, frame);
                }};
  };
  return {.name = method.name,
          .surface = method.surface,
          .earth = method.earth,
          .build_s = {},
          .ready_s = {},
          .memory_mib = {},
          .place = place};
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

// The way the program goes by default: as render/pixel_tracer.h chooses.
Contender default_way(const BenchDem& dem, const char* name, BenchEarth earth) {
  const Method method{name, SurfaceModel::hyperboloid, Search::pyramid, earth};
  Contender contender = scalar(dem, method);
  contender.place = [&dem, method, scalar_place = contender.place](const BenchView& view) {
    ViewTracer tracer = scalar_place(view);
    const auto columns = column_view(view.camera);
    const auto terrain = terrain_on(method.earth, dem, view, method.surface, method.search);
    tracer.shadow = [terrain, &view, map = std::shared_ptr<const SunMap>()](
                        const ShadowRays& rays, int threads, ShadowFrame& frame) mutable {
      if (!map) map = sun_map_of(*terrain, view, rays, threads);
      return shade_rays(*terrain, view, map.get(), rays, threads, frame);
    };
    if (EyeFront::serves(*terrain)) {
      tracer.primary = [terrain, &view](int threads, TracedFrame& frame) {
        const auto front = view_front(*terrain, view.camera, threads);
        return trace_front(*front, view.camera, threads, frame);
      };
    } else if (columns && has_columns(*terrain)) {
      tracer.primary = [terrain, columns = *columns](int threads, TracedFrame& frame) {
        return trace_strips(*terrain, columns, threads, frame);
      };
    }
    return tracer;
  };
  return contender;
}

// Shadow rays alone: with a map of the sun made for every frame, or without one.
Contender other_shadows(const BenchDem& dem, const char* name, bool makes_map) {
  Contender contender = scalar(dem, {name, SurfaceModel::hyperboloid, Search::pyramid});
  contender.place = [&dem, makes_map](const BenchView& view) -> ViewTracer {
    const auto terrain =
        terrain_on(BenchEarth::flat, dem, view, SurfaceModel::hyperboloid, Search::pyramid);
    const auto shade = [terrain, &view, makes_map](const ShadowRays& rays, int threads,
                                                   ShadowFrame& frame) {
      const auto map = makes_map ? sun_map_of(*terrain, view, rays, threads) : nullptr;
      return shade_rays(*terrain, view, map.get(), rays, threads, frame);
    };
    return {.primary = {}, .shadow = shade};
  };
  return contender;
}

Contender neighbour_way(const BenchDem& dem) {
  Contender contender = scalar(dem, {kNeighbourWay, SurfaceModel::hyperboloid, Search::pyramid});
  contender.place = [&dem](const BenchView& view) -> ViewTracer {
    const auto terrain =
        terrain_on(BenchEarth::flat, dem, view, SurfaceModel::hyperboloid, Search::pyramid);
    const auto trace = [terrain, &view](int threads, TracedFrame& frame) -> FrameWork {
      TraceCounts counts;
      const auto hits = trace_by_neighbours(*terrain, view.camera, threads, counts);
      parallel_for(frame.size_px.y, threads, [&](int row) {
        for (int column = 0; column < frame.size_px.x; ++column)
          store(hits.at(column, row), *terrain, frame, frame.index(column, row));
      });
      return {.tests = counts.tests, .nodes = counts.nodes};
    };
    return {.primary = trace, .shadow = {}};
  };
  return contender;
}

struct Built {
  double seconds;
  double mib;
};

Built build_pyramid(const HeightGrid& grid) {
  const auto start = std::chrono::steady_clock::now();
  const HeightCeilings ceilings(grid, [](int count, const std::function<void(int index)>& work) {
    parallel_for(count, 0, work);
  });
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
  return {spent.count(), static_cast<double>(ceilings.bytes()) / (1 << 20)};
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
  return {.name = "write-frame",
          .surface = {},
          .earth = BenchEarth::flat,
          .build_s = {},
          .ready_s = {},
          .memory_mib = {},
          .place = place};
}

}  // namespace

std::vector<Contender> terrview_contenders(const BenchDem& dem, const IsWanted& is_wanted) {
  std::vector<Contender> contenders{frame_writer(),
                                    default_way(dem, kDefaultWay, BenchEarth::flat),
                                    default_way(dem, kCurvedWay, BenchEarth::curved),
                                    default_way(dem, kBentWay, BenchEarth::bent),
                                    other_shadows(dem, kMapMadeWay, true),
                                    other_shadows(dem, kNoMapWay, false),
                                    neighbour_way(dem)};
  for (const SurfaceModel surface : kSurfaceModels) {
    contenders.push_back(scalar(dem, {"terrview-plain", surface, Search::plain}));
    contenders.push_back(scalar(dem, {"terrview-pyramid", surface, Search::pyramid}));
  }
  std::erase_if(contenders, [&](const Contender& each) { return !is_wanted(each.name); });
  const Built pyramid = build_pyramid(*dem.grid);
  for (Contender& each : contenders) {
    if (!each.surface || each.name == "terrview-plain") continue;
    each.build_s = pyramid.seconds;
    each.memory_mib = pyramid.mib;
  }
  return contenders;
}

}  // namespace terrview

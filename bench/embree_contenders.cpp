#include <array>
#include <memory>
#include <thread>

#include "bench/contender.h"
#include "bench/embree_ground.h"
#include "bench/embree_packets.h"
#include "render/parallel.h"

namespace terrview {
namespace {

constexpr std::array<const char*, 6> kCallNames{"1",         "8",      "16",
                                                "16-square", "stream", "stream-square"};

int bands(int rows_px, int rows_in_band) { return (rows_px + rows_in_band - 1) / rows_in_band; }

Contender contender(const std::string& name, const std::shared_ptr<const EmbreeGround>& ground,
                    EmbreeCalls calls) {
  const BandTracer tracer = band_tracer(calls);
  const auto place = [ground, tracer](const BenchView& view) -> ViewTracer {
    return {.primary =
                [ground, tracer, &view](int threads, TracedFrame& frame) {
                  const PrimaryJob job{*ground, view.eye_m, PixelRays(view.camera)};
                  parallel_for(bands(frame.size_px.y, tracer.rows), threads,
                               [&](int band) { tracer.primary(job, band * tracer.rows, frame); });
                  return FrameWork{};
                },
            .shadow =
                [ground, tracer, &view](const ShadowRays& rays, int threads, ShadowFrame& frame) {
                  const ShadowJob job{*ground, view.to_sun, rays};
                  parallel_for(bands(rays.size_px.y, tracer.rows), threads,
                               [&](int band) { tracer.shadow(job, band * tracer.rows, frame); });
                  return FrameWork{};
                }};
  };
  return {.name = name + "-" + kCallNames[static_cast<std::size_t>(calls)],
          .surface = SurfaceModel::triangles,
          .build_s = ground->build_s(),
          .memory_mib = ground->memory_mib(),
          .place = place};
}

}  // namespace

std::vector<Contender> embree_contenders(const BenchDem& dem) {
  const auto threads = static_cast<int>(std::thread::hardware_concurrency());
  const auto build = [&](EmbreeGeometry geometry) {
    return std::make_shared<const EmbreeGround>(dem, geometry, threads);
  };
  const auto triangles = build(EmbreeGeometry::triangles);
  const auto compact = build(EmbreeGeometry::compact_triangles);
  const auto grid = build(EmbreeGeometry::grid);
  std::vector<Contender> contenders;
  for (const EmbreeCalls calls :
       {EmbreeCalls::single, EmbreeCalls::packet8, EmbreeCalls::packet16,
        EmbreeCalls::packet16_square, EmbreeCalls::stream, EmbreeCalls::stream_square})
    contenders.push_back(contender("embree-tri", triangles, calls));
  for (const EmbreeCalls calls : {EmbreeCalls::packet16, EmbreeCalls::stream})
    contenders.push_back(contender("embree-compact", compact, calls));
  for (const EmbreeCalls calls : {EmbreeCalls::single, EmbreeCalls::packet8, EmbreeCalls::packet16,
                                  EmbreeCalls::packet16_square})
    contenders.push_back(contender("embree-grid", grid, calls));
  return contenders;
}

std::string embree_version() { return RTC_VERSION_STRING; }

}  // namespace terrview

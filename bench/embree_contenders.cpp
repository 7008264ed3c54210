#include <array>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "bench/contender.h"
#include "bench/embree_ground.h"
#include "bench/embree_packets.h"
#include "render/parallel.h"

namespace terrview {
namespace {

constexpr std::array<const char*, 6> kCallNames{"1",         "8",      "16",
                                                "16-square", "stream", "stream-square"};

struct Kind {
  const char* name;
  EmbreeGeometry geometry;
  std::vector<EmbreeCalls> calls;
};

// The packets that win for each, the one ray at a time that others start from.
const std::vector<Kind> kKinds{
    {"embree-tri",
     EmbreeGeometry::triangles,
     {EmbreeCalls::single, EmbreeCalls::packet8, EmbreeCalls::packet16,
      EmbreeCalls::packet16_square, EmbreeCalls::stream, EmbreeCalls::stream_square}},
    {"embree-compact",
     EmbreeGeometry::compact_triangles,
     {EmbreeCalls::packet16, EmbreeCalls::stream}},
    {"embree-grid",
     EmbreeGeometry::grid,
     {EmbreeCalls::single, EmbreeCalls::packet8, EmbreeCalls::packet16,
      EmbreeCalls::packet16_square}}};

std::string name_of(const Kind& kind, EmbreeCalls calls) {
  return std::string(kind.name) + "-" + kCallNames[static_cast<std::size_t>(calls)];
}

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
  return {.name = name,
          .surface = SurfaceModel::triangles,
          .earth = BenchEarth::flat,
          .build_s = ground->build_s(),
          .ready_s = ground->ready_s(),
          .memory_mib = ground->memory_mib(),
          .place = place};
}

}  // namespace

std::vector<Contender> embree_contenders(const BenchDem& dem, const IsWanted& is_wanted) {
  const auto threads = static_cast<int>(std::thread::hardware_concurrency());
  std::vector<Contender> contenders;
  for (const Kind& kind : kKinds) {
    std::shared_ptr<const EmbreeGround> ground;
    for (const EmbreeCalls calls : kind.calls) {
      if (!is_wanted(name_of(kind, calls))) continue;
      if (!ground) ground = std::make_shared<const EmbreeGround>(dem, kind.geometry, threads);
      contenders.push_back(contender(name_of(kind, calls), ground, calls));
    }
  }
  return contenders;
}

std::string embree_version() { return RTC_VERSION_STRING; }

}  // namespace terrview

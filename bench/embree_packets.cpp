#include "bench/embree_packets.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "bench/embree_calls.h"

namespace terrview {
namespace {

// Inlined into a function for one instruction set, a loop over lanes becomes that set's vectors.
#define TERRVIEW_LANES [[gnu::always_inline]] inline

constexpr float kFar = std::numeric_limits<float>::infinity();

// A lane that is not valid has an empty range: streams know no other way.
template <int kLanes, class Ray>
TERRVIEW_LANES void set_range(Ray& ray, const int* valid) {
  for (int lane = 0; lane < kLanes; ++lane) {
    ray.tnear[lane] = valid[lane] ? 0 : kFar;
    ray.tfar[lane] = valid[lane] ? kFar : -kFar;
    ray.time[lane] = 0;
    ray.mask[lane] = ~0U;
    ray.id[lane] = 0;
    ray.flags[lane] = 0;
  }
}

template <class How>
TERRVIEW_LANES void aim(const PrimaryJob& job, glm::ivec2 corner_px, glm::ivec2 size_px,
                        typename How::RayHit& packet, int* valid, double* lengths) {
  constexpr int kLanes = How::kLanes;
  auto& ray = packet.ray;
  auto& hit = packet.hit;
  for (int lane = 0; lane < kLanes; ++lane) {
    const int column = corner_px.x + lane % How::kWide;
    const int row = corner_px.y + lane / How::kWide;
    valid[lane] = column < size_px.x && row < size_px.y ? -1 : 0;
    const double x = job.rays.corner.x + column * job.rays.right.x + row * job.rays.down.x;
    const double y = job.rays.corner.y + column * job.rays.right.y + row * job.rays.down.y;
    const double z = job.rays.corner.z + column * job.rays.right.z + row * job.rays.down.z;
    lengths[lane] = std::sqrt(x * x + y * y + z * z);
    ray.dir_x[lane] = static_cast<float>(x);
    ray.dir_y[lane] = static_cast<float>(y);
    ray.dir_z[lane] = static_cast<float>(z);
    ray.org_x[lane] = static_cast<float>(job.eye_m.x);
    ray.org_y[lane] = static_cast<float>(job.eye_m.y);
    ray.org_z[lane] = static_cast<float>(job.eye_m.z);
    hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
    hit.instID[0][lane] = RTC_INVALID_GEOMETRY_ID;
    hit.primID[lane] = 0;
    hit.u[lane] = 0;
    hit.v[lane] = 0;
  }
  set_range<kLanes>(ray, valid);
}

template <int kLanes, class Hit>
TERRVIEW_LANES void cells_of(const EmbreeGround& ground, const Hit& hit, std::int32_t* cells) {
  if (ground.tiles().empty()) {
    for (int lane = 0; lane < kLanes; ++lane)
      cells[lane] = static_cast<std::int32_t>(hit.primID[lane] >> 1);
    return;
  }
  const EmbreeGround::Tile* tiles = ground.tiles().data();
  const std::int32_t cells_in_row = ground.cells_in_row();
  for (int lane = 0; lane < kLanes; ++lane) {
    const EmbreeGround::Tile& tile = tiles[hit.primID[lane]];
    const float east = std::min(hit.u[lane] * tile.cells_wide, tile.cells_wide - 1);
    const float north = std::min(hit.v[lane] * tile.cells_high, tile.cells_high - 1);
    cells[lane] = tile.first_cell + static_cast<std::int32_t>(east) -
                  static_cast<std::int32_t>(north) * cells_in_row;
  }
}

template <class How, class Value>
TERRVIEW_LANES void put(const Value* lanes, glm::ivec2 corner_px, glm::ivec2 size_px,
                        Value* plane) {
  const int rows = std::min(How::kRows, size_px.y - corner_px.y);
  const int columns = std::min(How::kWide, size_px.x - corner_px.x);
  for (int row = 0; row < rows; ++row) {
    Value* to = plane +
                static_cast<std::size_t>(corner_px.y + row) * static_cast<std::size_t>(size_px.x) +
                static_cast<std::size_t>(corner_px.x);
    if (columns == How::kWide) {
      for (int column = 0; column < How::kWide; ++column) to[column] = *lanes++;
    } else {
      std::copy_n(lanes, columns, to);
      lanes += How::kWide;
    }
  }
}

template <class How>
TERRVIEW_LANES void store(const EmbreeGround& ground, const typename How::RayHit& packet,
                          const double* lengths, glm::ivec2 corner_px, TracedFrame& frame) {
  constexpr int kLanes = How::kLanes;
  constexpr auto kCount = static_cast<std::size_t>(kLanes);
  const auto& hit = packet.hit;
  alignas(64) double distances_m[kCount];
  alignas(64) std::int32_t cells[kCount];
  alignas(64) float east[kCount];
  alignas(64) float north[kCount];
  cells_of<kLanes>(ground, hit, cells);
  for (int lane = 0; lane < kLanes; ++lane) {
    const bool found = hit.geomID[lane] != RTC_INVALID_GEOMETRY_ID;
    const float x = hit.Ng_x[lane];
    const float y = hit.Ng_y[lane];
    const float z = hit.Ng_z[lane];
    const float scale = (z < 0 ? -1.0F : 1.0F) / std::sqrt(x * x + y * y + z * z);
    distances_m[lane] = found ? static_cast<double>(packet.ray.tfar[lane]) * lengths[lane]
                              : std::numeric_limits<double>::infinity();
    cells[lane] = found ? cells[lane] : kNoCell;
    east[lane] = found ? x * scale : 0;
    north[lane] = found ? y * scale : 0;
  }
  put<How>(distances_m, corner_px, frame.size_px, frame.distance_m.data());
  put<How>(cells, corner_px, frame.size_px, frame.cell.data());
  put<How>(east, corner_px, frame.size_px, frame.normal_east.data());
  put<How>(north, corner_px, frame.size_px, frame.normal_north.data());
}

template <class How>
TERRVIEW_LANES void primary_band(const PrimaryJob& job, int top, TracedFrame& frame) {
  constexpr int kLanes = How::kLanes;
  constexpr auto kCount = static_cast<std::size_t>(kLanes);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  typename How::RayHit packets[How::kPackets];
  alignas(64) int valid[How::kPackets][kCount];
  alignas(64) double lengths[How::kPackets][kCount];
  for (int left = 0; left < frame.size_px.x; left += How::kWide * How::kPackets) {
    for (int i = 0; i < How::kPackets; ++i)
      aim<How>(job, {left + i * How::kWide, top}, frame.size_px, packets[i], valid[i], lengths[i]);
    How::intersect(valid[0], job.ground.scene(), &context, packets);
    for (int i = 0; i < How::kPackets && left + i * How::kWide < frame.size_px.x; ++i)
      store<How>(job.ground, packets[i], lengths[i], {left + i * How::kWide, top}, frame);
  }
}

template <class How>
TERRVIEW_LANES void get(const std::vector<float>& plane, glm::ivec2 corner_px, glm::ivec2 size_px,
                        float* lanes) {
  const int columns = std::min(How::kWide, size_px.x - corner_px.x);
  for (int row = corner_px.y; row < corner_px.y + How::kRows; ++row) {
    const bool inside = row < size_px.y;
    const float* from =
        plane.data() +
        static_cast<std::size_t>(inside ? row : 0) * static_cast<std::size_t>(size_px.x) +
        static_cast<std::size_t>(std::max(0, corner_px.x));
    if (inside && columns == How::kWide) {
      for (int column = 0; column < How::kWide; ++column) *lanes++ = from[column];
    } else {
      for (int column = 0; column < How::kWide; ++column)
        *lanes++ =
            inside && column < columns ? from[column] : std::numeric_limits<float>::quiet_NaN();
    }
  }
}

template <class How>
TERRVIEW_LANES void aim_at_sun(const ShadowJob& job, glm::ivec2 corner_px, typename How::Ray& ray,
                               int* valid) {
  constexpr int kLanes = How::kLanes;
  get<How>(job.rays.x_m, corner_px, job.rays.size_px, ray.org_x);
  get<How>(job.rays.y_m, corner_px, job.rays.size_px, ray.org_y);
  get<How>(job.rays.z_m, corner_px, job.rays.size_px, ray.org_z);
  for (int lane = 0; lane < kLanes; ++lane) {
    valid[lane] = ray.org_x[lane] == ray.org_x[lane] ? -1 : 0;
    ray.dir_x[lane] = static_cast<float>(job.to_sun.x);
    ray.dir_y[lane] = static_cast<float>(job.to_sun.y);
    ray.dir_z[lane] = static_cast<float>(job.to_sun.z);
  }
  set_range<kLanes>(ray, valid);
}

template <class How>
TERRVIEW_LANES void shadow_band(const ShadowJob& job, int top, ShadowFrame& frame) {
  constexpr int kLanes = How::kLanes;
  constexpr auto kCount = static_cast<std::size_t>(kLanes);
  const glm::ivec2 size_px = job.rays.size_px;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  typename How::Ray packets[How::kPackets];
  alignas(64) int valid[How::kPackets][kCount];
  alignas(64) std::uint8_t stopped[kCount];
  for (int left = 0; left < size_px.x; left += How::kWide * How::kPackets) {
    for (int i = 0; i < How::kPackets; ++i)
      aim_at_sun<How>(job, {left + i * How::kWide, top}, packets[i], valid[i]);
    How::occlude(valid[0], job.ground.scene(), &context, packets);
    for (int i = 0; i < How::kPackets && left + i * How::kWide < size_px.x; ++i) {
      for (int lane = 0; lane < kLanes; ++lane)
        stopped[lane] = valid[i][lane] && packets[i].tfar[lane] < 0 ? 1 : 0;
      put<How>(stopped, {left + i * How::kWide, top}, size_px, frame.data());
    }
  }
}

template <class How>
struct Baseline {
  static void primary(const PrimaryJob& job, int top, TracedFrame& frame) {
    primary_band<How>(job, top, frame);
  }
  static void shadow(const ShadowJob& job, int top, ShadowFrame& frame) {
    shadow_band<How>(job, top, frame);
  }
};

template <class How>
struct Avx2 {
  [[gnu::target("avx2")]] static void primary(const PrimaryJob& job, int top, TracedFrame& frame) {
    primary_band<How>(job, top, frame);
  }
  [[gnu::target("avx2")]] static void shadow(const ShadowJob& job, int top, ShadowFrame& frame) {
    shadow_band<How>(job, top, frame);
  }
};

#ifdef __clang__
#define TERRVIEW_AVX512 [[gnu::target("avx512f,avx512vl,avx512bw,avx512dq")]]
#else
#define TERRVIEW_AVX512 \
  [[gnu::target("avx512f,avx512vl,avx512bw,avx512dq,prefer-vector-width=512")]]
#endif

template <class How>
struct Avx512 {
  TERRVIEW_AVX512 static void primary(const PrimaryJob& job, int top, TracedFrame& frame) {
    primary_band<How>(job, top, frame);
  }
  TERRVIEW_AVX512 static void shadow(const ShadowJob& job, int top, ShadowFrame& frame) {
    shadow_band<How>(job, top, frame);
  }
};

template <class How>
BandTracer best_for_this_cpu() {
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
      __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq"))
    return {How::kRows, Avx512<How>::primary, Avx512<How>::shadow};
  if (__builtin_cpu_supports("avx2")) return {How::kRows, Avx2<How>::primary, Avx2<How>::shadow};
  return {How::kRows, Baseline<How>::primary, Baseline<How>::shadow};
}

}  // namespace

PixelRays::PixelRays(const Camera& camera) {
  const CameraOptions& options = camera.options();
  const glm::dvec2 size(options.size_px);
  const double k = std::tan(options.fov_rad / 2) / (size.x / 2);
  right = camera.right() * k;
  down = camera.up() * -k;
  corner = camera.forward() + right * (0.5 - size.x / 2) + down * (0.5 - size.y / 2);
}

BandTracer band_tracer(EmbreeCalls calls) {
  switch (calls) {
    case EmbreeCalls::single:
      return best_for_this_cpu<Single>();
    case EmbreeCalls::packet8:
      return best_for_this_cpu<Packet8>();
    case EmbreeCalls::packet16:
      return best_for_this_cpu<Packet16<8>>();
    case EmbreeCalls::packet16_square:
      return best_for_this_cpu<Packet16<4>>();
    case EmbreeCalls::stream:
      return best_for_this_cpu<Stream16<8>>();
    case EmbreeCalls::stream_square:
      break;
  }
  return best_for_this_cpu<Stream16<4>>();
}

}  // namespace terrview

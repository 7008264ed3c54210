#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>

#include "bench/objects/object_contender.h"

namespace terrview {
namespace {

constexpr unsigned kPacket = 16;

struct FloatBox {
  float low[3];
  float high[3];
};

float rounded_down(double v) {
  const auto f = static_cast<float>(v);
  return static_cast<double>(f) > v ? std::nextafter(f, -INFINITY) : f;
}
float rounded_up(double v) { return -rounded_down(-v); }

void bounds(const RTCBoundsFunctionArguments* args) {
  const FloatBox& box = static_cast<const FloatBox*>(args->geometryUserPtr)[args->primID];
  *args->bounds_o = {box.low[0],  box.low[1],  box.low[2],  0,
                     box.high[0], box.high[1], box.high[2], 0};
}

// Distances per lane, or infinity; N is 1 or kPacket. The slab test, in float.
template <int N>
inline void distances(const FloatBox& box, const float* ray, float* distance) {
  // The parts of RTCRayN: origin, nearest distance, direction, time, farthest distance.
  const float* near = ray + 3 * N;
  const float* far = ray + 8 * N;
  for (int i = 0; i < N; ++i) {
    float enter = -std::numeric_limits<float>::infinity();
    float leave = std::numeric_limits<float>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
      const float pace = 1.0F / ray[(4 + axis) * N + i];
      const float a = (box.low[axis] - ray[axis * N + i]) * pace;
      const float b = (box.high[axis] - ray[axis * N + i]) * pace;
      enter = std::max(enter, std::min(a, b));
      leave = std::min(leave, std::max(a, b));
    }
    const float at = enter >= near[i] ? enter : leave;
    const bool hit = enter <= leave && at >= near[i] && at <= far[i];
    distance[i] = hit ? at : std::numeric_limits<float>::infinity();
  }
}

__attribute__((target_clones("avx512f", "avx2", "default"))) void packet_distances(
    const FloatBox& box, const float* ray, float* distance) {
  distances<kPacket>(box, ray, distance);
}

void intersect(const RTCIntersectFunctionNArguments* args) {
  const FloatBox& box = static_cast<const FloatBox*>(args->geometryUserPtr)[args->primID];
  auto* ray = reinterpret_cast<float*>(args->rayhit);
  std::array<float, kPacket> distance;
  if (args->N == 1) {
    distances<1>(box, ray, distance.data());
  } else {
    packet_distances(box, ray, distance.data());
  }
  for (unsigned i = 0; i < args->N; ++i) {
    if (args->valid[i] == 0 || std::isinf(distance[i])) continue;
    RTCHitN* hit = RTCRayHitN_HitN(args->rayhit, args->N);
    ray[8 * args->N + i] = distance[i];
    RTCHitN_primID(hit, args->N, i) = args->primID;
    RTCHitN_geomID(hit, args->N, i) = args->geomID;
  }
}

void occluded(const RTCOccludedFunctionNArguments* args) {
  const FloatBox& box = static_cast<const FloatBox*>(args->geometryUserPtr)[args->primID];
  auto* ray = reinterpret_cast<float*>(args->ray);
  std::array<float, kPacket> distance;
  if (args->N == 1) {
    distances<1>(box, ray, distance.data());
  } else {
    packet_distances(box, ray, distance.data());
  }
  for (unsigned i = 0; i < args->N; ++i)
    if (args->valid[i] != 0 && !std::isinf(distance[i]))
      ray[8 * args->N + i] = -std::numeric_limits<float>::infinity();
}

// What the call-backs of single rays get to know of a ray: it in double, and what it has met.
struct ExactQuery {
  RTCIntersectContext context;
  const Ray* ray;
  std::optional<ObjectHit> nearest;
};

void intersect_exactly(const RTCIntersectFunctionNArguments* args) {
  auto& query = *reinterpret_cast<ExactQuery*>(args->context);
  const auto& objects = *static_cast<const Objects*>(args->geometryUserPtr);
  const auto hit = objects[args->primID]->first_hit(*query.ray);
  if (!hit || (query.nearest && hit->distance_m >= query.nearest->surface.distance_m)) return;
  query.nearest = ObjectHit{*hit, static_cast<int>(args->primID)};
  auto* it = reinterpret_cast<RTCRayHit*>(args->rayhit);
  it->ray.tfar = static_cast<float>(hit->distance_m);
  it->hit.geomID = args->geomID;
}

void stop_exactly(const RTCOccludedFunctionNArguments* args) {
  auto& query = *reinterpret_cast<ExactQuery*>(args->context);
  const auto& objects = *static_cast<const Objects*>(args->geometryUserPtr);
  if (objects[args->primID]->stops(*query.ray))
    reinterpret_cast<RTCRay*>(args->ray)->tfar = -std::numeric_limits<float>::infinity();
}

void exact_bounds(const RTCBoundsFunctionArguments* args) {
  const auto& objects = *static_cast<const Objects*>(args->geometryUserPtr);
  const Box box = objects[args->primID]->bounds();
  *args->bounds_o = {
      rounded_down(box.lowest_m.x), rounded_down(box.lowest_m.y), rounded_down(box.lowest_m.z), 0,
      rounded_up(box.highest_m.x),  rounded_up(box.highest_m.y),  rounded_up(box.highest_m.z),  0};
}

class EmbreeBoxes {
 public:
  EmbreeBoxes(const Objects& objects, bool exact)
      : device_(rtcNewDevice("threads=1")), objects_(objects) {
    if (device_ == nullptr) throw std::runtime_error("Embree: no device");
    rtcSetDeviceMemoryMonitorFunction(device_, count_bytes, this);
    for (const auto& object : objects) {
      const Box box = object->bounds();
      FloatBox& it = boxes_.emplace_back();
      for (int axis = 0; axis < 3; ++axis) {
        it.low[axis] = rounded_down(box.lowest_m[axis]);
        it.high[axis] = rounded_up(box.highest_m[axis]);
      }
    }
    scene_ = rtcNewScene(device_);
    const double start_s = processor_s();
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(boxes_.size()));
    if (exact) {
      rtcSetGeometryUserData(geometry, &objects_);
      rtcSetGeometryBoundsFunction(geometry, exact_bounds, nullptr);
      rtcSetGeometryIntersectFunction(geometry, intersect_exactly);
      rtcSetGeometryOccludedFunction(geometry, stop_exactly);
    } else {
      rtcSetGeometryUserData(geometry, boxes_.data());
      rtcSetGeometryBoundsFunction(geometry, bounds, nullptr);
      rtcSetGeometryIntersectFunction(geometry, intersect);
      rtcSetGeometryOccludedFunction(geometry, occluded);
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
    build_s_ = processor_s() - start_s;
  }
  ~EmbreeBoxes() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  EmbreeBoxes(const EmbreeBoxes&) = delete;
  EmbreeBoxes& operator=(const EmbreeBoxes&) = delete;

  [[nodiscard]] double build_s() const { return build_s_; }
  [[nodiscard]] double bytes() const {
    return static_cast<double>(bytes_) + static_cast<double>(boxes_.size() * sizeof(FloatBox));
  }
  [[nodiscard]] RTCScene scene() const { return scene_; }

 private:
  static bool count_bytes(void* boxes, ssize_t bytes, bool /*after*/) {
    static_cast<EmbreeBoxes*>(boxes)->bytes_ += bytes;
    return true;
  }

  RTCDevice device_;
  RTCScene scene_ = nullptr;
  Objects objects_;
  std::vector<FloatBox> boxes_;
  double build_s_ = 0;
  ssize_t bytes_ = 0;
};

RTCRay single(const Ray& ray) {
  return {static_cast<float>(ray.origin_m.x),
          static_cast<float>(ray.origin_m.y),
          static_cast<float>(ray.origin_m.z),
          0,
          static_cast<float>(ray.direction.x),
          static_cast<float>(ray.direction.y),
          static_cast<float>(ray.direction.z),
          0,
          static_cast<float>(ray.length_m),
          ~0U,
          0,
          0};
}

void set_lane(RTCRay16& packet, std::size_t i, const Ray& ray) {
  const RTCRay it = single(ray);
  packet.org_x[i] = it.org_x;
  packet.org_y[i] = it.org_y;
  packet.org_z[i] = it.org_z;
  packet.tnear[i] = 0;
  packet.dir_x[i] = it.dir_x;
  packet.dir_y[i] = it.dir_y;
  packet.dir_z[i] = it.dir_z;
  packet.time[i] = 0;
  packet.tfar[i] = it.tfar;
  packet.mask[i] = ~0U;
  packet.flags[i] = 0;
}

RTCIntersectContext coherent_context() {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  return context;
}

ObjectContender singles(const std::shared_ptr<const EmbreeBoxes>& boxes) {
  const auto first_hits = [boxes](std::span<const Ray> rays, std::span<Found> found) {
    RTCIntersectContext context = coherent_context();
    for (std::size_t i = 0; i < rays.size(); ++i) {
      RTCRayHit it{single(rays[i]), {}};
      it.hit.geomID = RTC_INVALID_GEOMETRY_ID;
      rtcIntersect1(boxes->scene(), &context, &it);
      if (it.hit.geomID != RTC_INVALID_GEOMETRY_ID)
        found[i] = {it.ray.tfar, static_cast<int>(it.hit.primID)};
    }
  };
  const auto stops = [boxes](std::span<const Ray> rays, std::span<std::uint8_t> stopped) {
    RTCIntersectContext context = coherent_context();
    for (std::size_t i = 0; i < rays.size(); ++i) {
      RTCRay it = single(rays[i]);
      rtcOccluded1(boxes->scene(), &context, &it);
      stopped[i] = it.tfar < 0 ? 1 : 0;
    }
  };
  return {"embree, single rays", boxes->build_s(), boxes->bytes(), first_hits, stops, nullptr};
}

ObjectContender packets(const std::shared_ptr<const EmbreeBoxes>& boxes) {
  const auto first_hits = [boxes](std::span<const Ray> rays, std::span<Found> found) {
    RTCIntersectContext context = coherent_context();
    for (std::size_t begin = 0; begin < rays.size(); begin += kPacket) {
      RTCRayHit16 it;
      std::array<int, kPacket> valid{};
      const std::size_t count = std::min<std::size_t>(kPacket, rays.size() - begin);
      for (std::size_t i = 0; i < count; ++i) {
        set_lane(it.ray, i, rays[begin + i]);
        it.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
        valid[i] = -1;
      }
      rtcIntersect16(valid.data(), boxes->scene(), &context, &it);
      for (std::size_t i = 0; i < count; ++i)
        if (it.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID)
          found[begin + i] = {it.ray.tfar[i], static_cast<int>(it.hit.primID[i])};
    }
  };
  const auto stops = [boxes](std::span<const Ray> rays, std::span<std::uint8_t> stopped) {
    RTCIntersectContext context = coherent_context();
    for (std::size_t begin = 0; begin < rays.size(); begin += kPacket) {
      RTCRay16 it;
      std::array<int, kPacket> valid{};
      const std::size_t count = std::min<std::size_t>(kPacket, rays.size() - begin);
      for (std::size_t i = 0; i < count; ++i) {
        set_lane(it, i, rays[begin + i]);
        valid[i] = -1;
      }
      rtcOccluded16(valid.data(), boxes->scene(), &context, &it);
      for (std::size_t i = 0; i < count; ++i) stopped[begin + i] = it.tfar[i] < 0 ? 1 : 0;
    }
  };
  return {"embree, packets of 16", boxes->build_s(), boxes->bytes(), first_hits, stops, nullptr};
}

ObjectContender exact_singles(const std::shared_ptr<const EmbreeBoxes>& boxes) {
  const auto query_of = [] {
    ExactQuery query;
    rtcInitIntersectContext(&query.context);
    query.context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    return query;
  };
  const auto first_hits = [boxes, query_of](std::span<const Ray> rays, std::span<Found> found) {
    ExactQuery query = query_of();
    for (std::size_t i = 0; i < rays.size(); ++i) {
      query.ray = &rays[i];
      query.nearest.reset();
      RTCRayHit it{single(rays[i]), {}};
      rtcIntersect1(boxes->scene(), &query.context, &it);
      if (query.nearest) found[i] = {query.nearest->surface.distance_m, query.nearest->object};
    }
  };
  const auto stops = [boxes, query_of](std::span<const Ray> rays, std::span<std::uint8_t> stopped) {
    ExactQuery query = query_of();
    for (std::size_t i = 0; i < rays.size(); ++i) {
      query.ray = &rays[i];
      RTCRay it = single(rays[i]);
      rtcOccluded1(boxes->scene(), &query.context, &it);
      stopped[i] = it.tfar < 0 ? 1 : 0;
    }
  };
  return {
      "embree, single rays, objects", boxes->build_s(), boxes->bytes(), first_hits, stops, nullptr};
}

}  // namespace

std::vector<ObjectContender> embree_object_contenders(const Objects& objects) {
  const auto boxes = std::make_shared<const EmbreeBoxes>(objects, false);
  return {singles(boxes), packets(boxes),
          exact_singles(std::make_shared<const EmbreeBoxes>(objects, true))};
}

}  // namespace terrview

// How rays are handed to Embree: one by one, in packets, in streams of packets. Each struct has
// kLanes rays a packet and kPackets packets a call; rays that are not valid are left alone.
#pragma once

#include <embree3/rtcore.h>

namespace terrview {

inline constexpr int kTileWide_px = 4;

template <int kLanes>
struct Packet;
template <>
struct Packet<8> {
  using RayHit = RTCRayHit8;
  using Ray = RTCRay8;
};
template <>
struct Packet<16> {
  using RayHit = RTCRayHit16;
  using Ray = RTCRay16;
};

// How the rays of `kPackets` packets of `kLanes` lanes are handed to Embree.
template <int kLaneCount, int kPacketCount>
struct Calls {
  static constexpr int kLanes = kLaneCount;
  static constexpr int kPackets = kPacketCount;
  static constexpr int kRows = kLanes / kTileWide_px;
  using RayHit = typename Packet<kLanes>::RayHit;
  using Ray = typename Packet<kLanes>::Ray;
};

struct Packet8 : Calls<8, 1> {
  static void intersect(const int* valid, RTCScene scene, RTCIntersectContext* context,
                        RayHit* packet) {
    rtcIntersect8(valid, scene, context, packet);
  }
  static void occlude(const int* valid, RTCScene scene, RTCIntersectContext* context, Ray* packet) {
    rtcOccluded8(valid, scene, context, packet);
  }
};

struct Packet16 : Calls<16, 1> {
  static void intersect(const int* valid, RTCScene scene, RTCIntersectContext* context,
                        RayHit* packet) {
    rtcIntersect16(valid, scene, context, packet);
  }
  static void occlude(const int* valid, RTCScene scene, RTCIntersectContext* context, Ray* packet) {
    rtcOccluded16(valid, scene, context, packet);
  }
};

struct Stream16 : Calls<16, 16> {
  static void intersect(const int* /*valid*/, RTCScene scene, RTCIntersectContext* context,
                        RayHit* packets) {
    rtcIntersectNM(scene, context, reinterpret_cast<RTCRayHitN*>(packets), kLanes, kPackets,
                   sizeof(RayHit));
  }
  static void occlude(const int* /*valid*/, RTCScene scene, RTCIntersectContext* context,
                      Ray* packets) {
    rtcOccludedNM(scene, context, reinterpret_cast<RTCRayN*>(packets), kLanes, kPackets,
                  sizeof(Ray));
  }
};

template <class Soa>
RTCRay ray_of(const Soa& rays, int lane) {
  return {rays.org_x[lane],
          rays.org_y[lane],
          rays.org_z[lane],
          rays.tnear[lane],
          rays.dir_x[lane],
          rays.dir_y[lane],
          rays.dir_z[lane],
          0,
          rays.tfar[lane],
          rays.mask[lane],
          0,
          0};
}

struct Single : Calls<16, 1> {
  static void intersect(const int* valid, RTCScene scene, RTCIntersectContext* context,
                        RayHit* packet) {
    for (int lane = 0; lane < kLanes; ++lane) {
      if (!valid[lane]) continue;
      RTCRayHit one{};
      one.ray = ray_of(packet->ray, lane);
      one.hit.geomID = RTC_INVALID_GEOMETRY_ID;
      rtcIntersect1(scene, context, &one);
      packet->ray.tfar[lane] = one.ray.tfar;
      packet->hit.Ng_x[lane] = one.hit.Ng_x;
      packet->hit.Ng_y[lane] = one.hit.Ng_y;
      packet->hit.Ng_z[lane] = one.hit.Ng_z;
      packet->hit.u[lane] = one.hit.u;
      packet->hit.v[lane] = one.hit.v;
      packet->hit.primID[lane] = one.hit.primID;
      packet->hit.geomID[lane] = one.hit.geomID;
    }
  }
  static void occlude(const int* valid, RTCScene scene, RTCIntersectContext* context, Ray* packet) {
    for (int lane = 0; lane < kLanes; ++lane) {
      if (!valid[lane]) continue;
      RTCRay one = ray_of(*packet, lane);
      rtcOccluded1(scene, context, &one);
      packet->tfar[lane] = one.tfar;
    }
  }
};

}  // namespace terrview

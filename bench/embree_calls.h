// How rays are handed to Embree: one by one, in packets, in streams of packets. Each struct has
// kLanes rays a packet, from a tile of kWide pixels by kRows, and kPackets packets a call; rays
// that are not valid are left alone.
#pragma once

#include <embree3/rtcore.h>

namespace terrview {

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

template <int kLaneCount, int kPacketCount, int kTileWide>
struct Calls {
  static constexpr int kLanes = kLaneCount;
  static constexpr int kPackets = kPacketCount;
  static constexpr int kWide = kTileWide;
  static constexpr int kRows = kLanes / kWide;
  using RayHit = typename Packet<kLanes>::RayHit;
  using Ray = typename Packet<kLanes>::Ray;
};

struct Packet8 : Calls<8, 1, 4> {
  static void intersect(const int* valid, RTCScene scene, RTCIntersectContext* context,
                        RayHit* packet) {
    rtcIntersect8(valid, scene, context, packet);
  }
  static void occlude(const int* valid, RTCScene scene, RTCIntersectContext* context, Ray* packet) {
    rtcOccluded8(valid, scene, context, packet);
  }
};

template <int kTileWide>
struct Packet16 : Calls<16, 1, kTileWide> {
  using typename Calls<16, 1, kTileWide>::RayHit;
  using typename Calls<16, 1, kTileWide>::Ray;

  static void intersect(const int* valid, RTCScene scene, RTCIntersectContext* context,
                        RayHit* packet) {
    rtcIntersect16(valid, scene, context, packet);
  }
  static void occlude(const int* valid, RTCScene scene, RTCIntersectContext* context, Ray* packet) {
    rtcOccluded16(valid, scene, context, packet);
  }
};

template <int kTileWide>
struct Stream16 : Calls<16, 16, kTileWide> {
  using typename Calls<16, 16, kTileWide>::RayHit;
  using typename Calls<16, 16, kTileWide>::Ray;

  static void intersect(const int* /*valid*/, RTCScene scene, RTCIntersectContext* context,
                        RayHit* packets) {
    rtcIntersectNM(scene, context, reinterpret_cast<RTCRayHitN*>(packets), 16, 16, sizeof(RayHit));
  }
  static void occlude(const int* /*valid*/, RTCScene scene, RTCIntersectContext* context,
                      Ray* packets) {
    rtcOccludedNM(scene, context, reinterpret_cast<RTCRayN*>(packets), 16, 16, sizeof(Ray));
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

struct Single : Calls<16, 1, 8> {
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

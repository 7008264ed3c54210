// Bands of an image traced with Embree, one ray at a time or in packets.
//
// Rays are made tile by tile, straight into packets; the loops over a tile's lanes are compiled for
// SSE2, AVX2 and AVX-512, and the widest that the processor has is chosen. They run in double
// precision up to the last rounding: that costs nothing measurable here.
#pragma once

#include <glm/vec3.hpp>

#include "bench/embree_ground.h"
#include "bench/traced_frame.h"
#include "render/camera.h"

namespace terrview {

// Wide tiles are the faster by up to a tenth in level views, square ones by a twentieth in steep
// ones.
enum class EmbreeCalls {
  single,           // rtcIntersect1, rtcOccluded1
  packet8,          // rtcIntersect8, 4 x 2 pixels
  packet16,         // rtcIntersect16, 8 x 2 pixels
  packet16_square,  // 4 x 4 pixels
  stream,           // rtcIntersectNM: 16 packets of 8 x 2 pixels
  stream_square,    // 16 packets of 4 x 4 pixels
};

// The direction of pixel (i, j), not normalised: corner + i * right + j * down.
struct PixelRays {
  explicit PixelRays(const Camera& camera);

  glm::dvec3 corner;
  glm::dvec3 right;
  glm::dvec3 down;
};

struct PrimaryJob {
  const EmbreeGround& ground;
  glm::dvec3 eye_m;
  PixelRays rays;
};

struct ShadowJob {
  const EmbreeGround& ground;
  glm::dvec3 to_sun;
  const ShadowRays& rays;
};

// Each call traces the rows from `top`, as many as `rows`, the last of them perhaps outside.
struct BandTracer {
  int rows;
  void (*primary)(const PrimaryJob& job, int top, TracedFrame& frame);
  void (*shadow)(const ShadowJob& job, int top, ShadowFrame& frame);
};

[[nodiscard]] BandTracer band_tracer(EmbreeCalls calls);

}  // namespace terrview

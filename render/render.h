// A Scene through a Camera.
#pragma once

#include <cstdint>
#include <functional>

#include <glm/vec3.hpp>

#include "render/camera.h"
#include "render/image.h"
#include "render/scene.h"

namespace terrview {

struct RenderOptions {
  int threads = 0;            // 0 = all the processor has; never changes the picture
  bool coherence = true;      // false: every ray on its own; the same picture, later
  bool keep_samples = false;  // fill Frame::samples
  // Called from any thread with the share done, 0 to 1; what it throws ends the rendering.
  std::function<void(double share)> progress = {};
};

// What the ray through a pixel's centre meets.
struct PixelSample {
  glm::dvec3 position_m{0, 0, 0};  // view frame
  glm::vec3 normal{0, 0, 0};       // as Terrain's normals
  std::int32_t object_id = kNothing;

  static constexpr std::int32_t kNothing = -1;
  static constexpr std::int32_t kGround = 0;
};

struct RenderCounts {
  std::int64_t rays = 0;  // from the eye
  std::int64_t hits = 0;
  std::int64_t tests = 0;  // spans of ground compared with those rays
  std::int64_t nodes = 0;  // blocks of the pyramid compared with them
  std::int64_t shadow_rays = 0;
  double trace_s = 0;  // summed over the threads
  double shade_s = 0;

  RenderCounts& operator+=(const RenderCounts& other);
};

struct Frame {
  Image image;
  Raster<PixelSample> samples;  // empty unless asked for
  RenderCounts counts;
};

[[nodiscard]] Frame render(const Scene& scene, const Camera& camera,
                           const RenderOptions& options = {});

}  // namespace terrview

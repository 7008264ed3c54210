// A Scene through a Camera.
#pragma once

#include <cstdint>
#include <functional>

#include <glm/vec3.hpp>

#include "render/camera.h"
#include "render/image.h"
#include "render/objects/object_set.h"
#include "render/scene.h"

namespace terrview {

// What the rays of a picture owe to each other.
enum class Coherence {
  on,
  off,         // every ray on its own: the same picture, later
  neighbours,  // through the pixels' centres as in render/neighbour_tracer.h, which may miss; not
               // for an orthographic camera
};

struct RenderOptions {
  int threads = 0;  // 0 = all the processor has; never changes the picture
  Coherence coherence = Coherence::on;
  bool keep_samples = false;  // fill Frame::samples
  // Rays a pixel. 0 = as many as it needs: one; four where it differs from a neighbour by more than
  // `contrast`; sixteen where those four do among themselves, or where the ground beside it is a
  // quarter further or nearer.
  int samples = 1;
  float contrast = 0.03F;  // of a component in sRGB, 0 to 1
  // Where haze blurs enough, three pixels of four are left to the blur. False: every pixel is
  // traced; nearly the same picture, later.
  bool sparse_haze = true;
  // Only blocks of 8 x 8 pixels, refined to smaller ones where their corners differ by more than
  // `contrast`; for a quick look. No haze, and one ray a pixel.
  bool preview = false;
  // Called with better and better pictures, from such blocks on; the last is the frame's own. The
  // frame is the same as without, to the byte.
  std::function<void(const Image& image)> improved = {};
  // Called from any thread with the share done, 0 to 1; what it throws ends the rendering.
  std::function<void(double share)> progress = {};
};

// What the ray through a pixel's centre meets.
struct PixelSample {
  glm::dvec3 position_m{0, 0, 0};  // view frame
  glm::vec3 normal{0, 0, 0};       // as Terrain's normals
  std::int32_t object_id = kNothing;
  // Colour = clear * transmission + air * (1 - transmission).
  glm::vec3 clear{0, 0, 0};
  glm::vec3 air{0, 0, 0};
  float transmission = 1;

  static constexpr std::int32_t kNothing = -1;
  static constexpr std::int32_t kGround = 0;  // objects have numbers above it
};

struct RenderCounts {
  std::int64_t rays = 0;  // from the eye
  std::int64_t hits = 0;
  std::int64_t tests = 0;  // spans of ground compared with those rays
  std::int64_t nodes = 0;  // blocks of the pyramid compared with them
  std::int64_t shadow_rays = 0;
  ObjectCounts objects;         // of the rays from the eye
  ObjectCounts shadow_objects;  // of the shadow rays
  double trace_s = 0;           // summed over the threads
  double shade_s = 0;

  RenderCounts& operator+=(const RenderCounts& other);
};

struct Frame {
  Image image;
  Raster<PixelSample> samples;  // empty unless asked for
  RenderCounts counts;
};

// A camera that shows a part of a picture gets that part of it, to the byte, but not with
// Coherence::neighbours. So do views around one circle of pixels where they overlap (camera.h),
// with `preview` where its pixels are a multiple of 8, with haze of 2.
[[nodiscard]] Frame render(const Scene& scene, const Camera& camera,
                           const RenderOptions& options = {});

}  // namespace terrview

// The sky of one view, painted where it is looked at.
//
// Each window of pixels is painted when the first ray that meets nothing asks for one of it: what
// the ground hides altogether costs nothing, and the picture does not depend on who asks first.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "render/camera.h"
#include "sky/cloud_shadows.h"
#include "sky/sky_painter.h"

namespace terrview {

// The camera as the sky sees it, with the whole of its picture; an orthographic one looks one way,
// which no painting shows.
[[nodiscard]] SkyCamera sky_camera(const Camera& camera);

// The same, but for pixels that belong to a circle: of all that circle, from its first pixel that
// begins east of north. All views that share their pixels have one sky.
[[nodiscard]] SkyCamera painted_camera(const Camera& camera);

class PaintedSky {
 public:
  PaintedSky(const SkyOptions& sky, const Camera& camera, bool cloud_shadows);

  // The sky that level mirrors show to `camera`, for the directions of the rays that they reflect.
  [[nodiscard]] static std::shared_ptr<const PaintedSky> mirrored(const SkyOptions& sky,
                                                                  const Camera& camera,
                                                                  bool cloud_shadows);

  ~PaintedSky();
  PaintedSky(const PaintedSky&) = delete;
  PaintedSky& operator=(const PaintedSky&) = delete;

  // Linear Rec. 709: the pixel of painted_camera() that a direction of unit length falls into; the
  // clear sky in orthographic views.
  [[nodiscard]] glm::vec3 color(const glm::dvec3& direction) const;

  // The clear sky, in any direction of unit length.
  [[nodiscard]] glm::vec3 clear_color(const glm::dvec3& direction) const {
    return painter_.clear_color(direction);
  }

  // The background's at the horizon under or over a direction, without the sun and its halo.
  [[nodiscard]] glm::vec3 horizon_color(const glm::dvec3& direction) const;

  // The share of the sun that clouds let through to a point of the view frame: 1 without shadows.
  [[nodiscard]] float sun_share(const glm::dvec3& point_m) const {
    return shadows_ ? shadows_->share(point_m) : 1;
  }

 private:
  PaintedSky(const SkyOptions& sky, const SkyCamera& camera, bool has_pixels, bool cloud_shadows);

  struct Window {
    std::once_flag painted;
    std::vector<glm::vec3> colors;
  };

  void paint(const glm::ivec2& at, Window& window) const;
  [[nodiscard]] glm::ivec2 window_size(const glm::ivec2& at) const;

  SkyCamera camera_;
  SkyPainter painter_;
  std::optional<CloudShadows> shadows_;
  bool has_pixels_;
  glm::ivec2 window_count_;
  std::vector<glm::vec3> horizon_;  // by place on each side of a square
  // Filled through const calls, once each: callers see immutable colours.
  std::unique_ptr<Window[]> windows_;
};

}  // namespace terrview

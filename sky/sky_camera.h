// A view of the sky: which way each pixel looks. East-north-up at the eye, as render's camera.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace terrview {

struct SkyCamera {
  glm::ivec2 size_px{0, 0};
  glm::dvec2 middle_px{0, 0};  // where `forward` shows
  double focal_px = 1;         // pixels per unit of tangent; cylindrical: per radian of azimuth too
  glm::dvec3 forward{0, 1, 0};
  glm::dvec3 right{1, 0, 0};
  glm::dvec3 up{0, 0, 1};
  bool cylindrical = false;  // then level

  // Through a point of the image, row 0 at the top; not of unit length.
  [[nodiscard]] glm::dvec3 direction(const glm::dvec2& image_px) const;

  // Where a direction shows; behind a perspective view, where its opposite would.
  [[nodiscard]] glm::dvec2 image_of(const glm::dvec3& direction) const;

  // The perspective view that shows the same near a column, there: this one itself, but for
  // cylinders.
  [[nodiscard]] SkyCamera facing(double column_px) const;
};

}  // namespace terrview

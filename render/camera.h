// The camera: from pixels to rays of the view frame, whose origin is the eye.
//
// Perspective: pixel (i, j), row 0 at the top, looks along
//   F + R (i + 0.5 - W/2) k + U (H/2 - j - 0.5) k,   k = tan(fov / 2) / (W / 2)
// with F, R, U the forward, right and up unit vectors; roll r turns them to R cos r - U sin r and
// U cos r + R sin r. Cylindrical: azimuth = heading + (i + 0.5 - W/2) fov / W, and the vertical is
// linear in the tangent of the elevation with focal length W / fov pixels; no pitch, no roll.
// Orthographic: parallel rays along F, `width_m` across W pixels.
#pragma once

#include <optional>
#include <span>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "terrain/column_tracer.h"
#include "terrain/direction_row.h"
#include "terrain/ray.h"

namespace terrview {

enum class Projection { perspective, cylindrical, orthographic };

struct CameraOptions {
  Projection projection = Projection::perspective;
  double heading_rad = 0;               // clockwise from true north
  double pitch_rad = 0;                 // up
  double roll_rad = 0;                  // clockwise as seen from behind the camera
  double fov_rad = 1.0471975511965976;  // horizontal field of view; unused by orthographic
  double width_m = 0;                   // orthographic only
  glm::ivec2 size_px{1280, 720};
};

class Camera {
 public:
  // Throws InputError for a field of view, size or width that makes no picture.
  explicit Camera(const CameraOptions& options);

  // The ray through a point of the image: pixel (i, j) has its centre at (i + 0.5, j + 0.5). Its
  // direction is not of unit length: where columns of the image are vertical planes (cylindrical,
  // and perspective without pitch and roll) x and y are equal, bit for bit, along a column, and z
  // along a row.
  [[nodiscard]] Ray ray(glm::dvec2 image_px) const;

  // The directions of the rays through the points first_px, first_px + (1, 0), ..., as many as x, y
  // and z have room for, which must be alike.
  void aim_row(glm::dvec2 first_px, const DirectionSpans& directions) const;

  // Where a point of the view frame falls on the image; nullopt behind the camera.
  [[nodiscard]] std::optional<glm::dvec2> project(const glm::dvec3& point_m) const;

  // Of one pixel in the middle: on the image plane at distance 1, in radians (cylindrical), or in
  // metres (orthographic).
  [[nodiscard]] double pixel_size() const { return per_px_; }
  [[nodiscard]] const CameraOptions& options() const { return options_; }
  // The size of a pixel: on the image plane at distance 1, radians, or metres of an orthographic
  // one.
  [[nodiscard]] double per_px() const { return per_px_; }
  [[nodiscard]] const glm::dvec3& forward() const { return forward_; }
  [[nodiscard]] const glm::dvec3& right() const { return right_; }
  [[nodiscard]] const glm::dvec3& up() const { return up_; }

 private:
  CameraOptions options_;
  glm::dvec3 forward_;
  glm::dvec3 right_;
  glm::dvec3 up_;
  double per_px_ = 0;  // on the image plane, radians or metres
};

// Image points in columns and rows: point (i, j) is first_px + step_px * (i, j).
struct PixelLattice {
  glm::dvec2 first_px{0.5, 0.5};
  int step_px = 1;
  glm::ivec2 count;

  [[nodiscard]] glm::dvec2 at(glm::ivec2 point) const {
    return first_px + static_cast<double>(step_px) * glm::dvec2(point);
  }
};

// The lattice of the centres of the camera's pixels.
[[nodiscard]] PixelLattice pixel_centres(const Camera& camera);

// The camera's rays through a lattice column by column, where columns of the image are vertical
// planes through the eye.
[[nodiscard]] std::optional<ColumnView> column_view(const Camera& camera,
                                                    const PixelLattice& lattice);
[[nodiscard]] inline std::optional<ColumnView> column_view(const Camera& camera) {
  return column_view(camera, pixel_centres(camera));
}

}  // namespace terrview

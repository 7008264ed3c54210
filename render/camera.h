// The camera: from pixels to rays of the view frame, whose origin is the eye.
//
// Perspective: pixel (i, j), row 0 at the top, looks along
//   F + R (i + 0.5 - W/2) k + U (H/2 - j - 0.5) k,   k = tan(fov / 2) / (W / 2)
// with F, R, U the forward, right and up unit vectors; roll r turns them to R cos r - U sin r and
// U cos r + R sin r. Cylindrical: azimuth = heading + (i + 0.5 - W/2) fov / W, and the vertical is
// linear in the tangent of the elevation with focal length W / fov pixels; no pitch, no roll.
// Orthographic: parallel rays along F, `width_m` across W pixels. A shifted lens moves the picture
// over its image plane: the view's middle, W/2 and H/2 above, lies `shift` off the picture's.
//
// A camera may show a part of its picture. Its rays are those of the whole, bit for bit. Pixels of
// a cylindrical view that fit into a circle a whole number of times are those of the one circle
// that begins in the north (but for the last millionth of a pixel of their heading), so that views
// of other headings share rays where they share columns, and a whole turn closes.
#pragma once

#include <optional>
#include <span>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "terrain/direction_row.h"
#include "terrain/ray.h"

namespace terrview {

enum class Projection { perspective, cylindrical, orthographic };

// A rectangle of pixels of a picture.
struct PixelRect {
  glm::ivec2 first_px{0, 0};
  glm::ivec2 size_px{0, 0};

  bool operator==(const PixelRect&) const = default;
};

struct CameraOptions {
  Projection projection = Projection::perspective;
  double heading_rad = 0;               // clockwise from true north
  double pitch_rad = 0;                 // up
  double roll_rad = 0;                  // clockwise as seen from behind the camera
  double fov_rad = 1.0471975511965976;  // horizontal field of view; unused by orthographic
  double width_m = 0;                   // orthographic only
  // Of the lens, to the right and up, as shares of the picture's width and height: a view that is
  // shifted up shows more of the sky. Cylindrical only up, orthographic not at all.
  glm::dvec2 shift{0, 0};
  glm::ivec2 size_px{1280, 720};
};

class Camera {
 public:
  // Throws InputError for a field of view, size, width or shift that makes no picture.
  explicit Camera(const CameraOptions& options);

  // The camera that shows a part of this one's image, or what lies beside it. Its options are this
  // one's but for the size.
  [[nodiscard]] Camera part(const PixelRect& rect) const;

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

  [[nodiscard]] const CameraOptions& options() const { return options_; }
  // Of one pixel in the middle: on the image plane at distance 1, in radians (cylindrical), or in
  // metres (orthographic).
  [[nodiscard]] double per_px() const { return per_px_; }
  // The picture that this image is a part of: that of the options the camera was made with.
  [[nodiscard]] const glm::ivec2& whole_px() const { return whole_px_; }
  [[nodiscard]] const glm::ivec2& first_px() const { return first_px_; }
  // The image point on the axis of the lens, or of a cylindrical view on its heading's horizon.
  [[nodiscard]] const glm::dvec2& middle_px() const { return middle_px_; }
  // The pixels around the circle that those of a cylindrical view belong to; 0 where they do not
  // fit into one. The image begins `east_px` east of north.
  [[nodiscard]] int circle_px() const { return circle_px_; }
  [[nodiscard]] double east_px() const { return east_px_; }
  [[nodiscard]] const glm::dvec3& forward() const { return forward_; }
  [[nodiscard]] const glm::dvec3& right() const { return right_; }
  [[nodiscard]] const glm::dvec3& up() const { return up_; }

 private:
  void lay_on_circle();
  [[nodiscard]] double azimuth(double image_x_px) const;

  CameraOptions options_;
  glm::ivec2 whole_px_;
  glm::ivec2 first_px_{0, 0};
  glm::dvec2 middle_px_;
  glm::dvec3 forward_;
  glm::dvec3 right_;
  glm::dvec3 up_;
  double per_px_ = 0;  // on the image plane, radians or metres
  int circle_px_ = 0;
  double east_px_ = 0;
};

}  // namespace terrview

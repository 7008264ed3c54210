#include "render/camera.h"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

#include <glm/geometric.hpp>

#include "terrain/error.h"

namespace terrview {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kLargestSide_px = 1 << 20;
constexpr double kLargestShift = 16;
// A whole number of pixels to the circle, but for rounding.
constexpr double kWhole = 1e-9;

// To a millionth of a pixel: sums of such numbers and of pixels are exact.
double in_millionths(double value_px) { return std::round(value_px * 0x1p20) * 0x1p-20; }

void check_shift(const CameraOptions& options) {
  const glm::dvec2 shift = options.shift;
  if (!(std::abs(shift.x) <= kLargestShift && std::abs(shift.y) <= kLargestShift))
    throw InputError("--shift: give shares of the picture's width and height, as 0,0.25");
  if (options.projection == Projection::cylindrical && shift.x != 0)
    throw InputError("--shift: a cylindrical view is shifted up or down only: turn its --heading");
  if (options.projection == Projection::orthographic && shift != glm::dvec2(0))
    throw InputError("--shift: an orthographic view has no lens: move the eye");
}

void check(const CameraOptions& options) {
  const glm::ivec2 size = options.size_px;
  if (size.x < 1 || size.y < 1 || size.x > kLargestSide_px || size.y > kLargestSide_px)
    throw InputError("--size: " + std::to_string(size.x) + "x" + std::to_string(size.y) +
                     ": give a width and height from 1 to " + std::to_string(kLargestSide_px));
  const bool flat = options.projection == Projection::perspective;
  const double widest = flat ? kPi : 2 * kPi;
  const bool uses_fov = options.projection != Projection::orthographic;
  // A whole turn is a panorama; half a turn has no flat image.
  const bool fits = flat ? options.fov_rad < widest : options.fov_rad <= widest * (1 + 1e-12);
  if (uses_fov && !(options.fov_rad > 0 && fits))
    throw InputError(flat ? "--fov: a perspective view: give more than 0 and less than 180 degrees"
                          : "--fov: a cylindrical view: give more than 0 and up to 360 degrees");
  if (!uses_fov && !(options.width_m > 0))
    throw InputError("--width: an orthographic view: give the width of the picture in metres");
  if (options.projection == Projection::cylindrical &&
      (options.pitch_rad != 0 || options.roll_rad != 0))
    throw InputError("--pitch, --roll: a cylindrical view: it is level; leave them out");
  check_shift(options);
}

// On the image plane at distance 1; in radians; in metres.
double size_of_pixel(const CameraOptions& options) {
  const double width_px = options.size_px.x;
  switch (options.projection) {
    case Projection::perspective:
      return std::tan(options.fov_rad / 2) / (width_px / 2);
    case Projection::cylindrical:
      return options.fov_rad / width_px;
    case Projection::orthographic:
      return options.width_m / width_px;
  }
  return 0;
}

}  // namespace

Camera::Camera(const CameraOptions& options) : options_(options), whole_px_(options.size_px) {
  check(options);
  per_px_ = size_of_pixel(options);
  const glm::dvec2 size(options.size_px);
  middle_px_ = {size.x / 2 - in_millionths(options.shift.x * size.x),
                size.y / 2 + in_millionths(options.shift.y * size.y)};
  if (options.projection == Projection::cylindrical) lay_on_circle();
  const double sin_heading = std::sin(options.heading_rad);
  const double cos_heading = std::cos(options.heading_rad);
  const double sin_pitch = std::sin(options.pitch_rad);
  const double cos_pitch = std::cos(options.pitch_rad);
  forward_ = {sin_heading * cos_pitch, cos_heading * cos_pitch, sin_pitch};
  const glm::dvec3 level(cos_heading, -sin_heading, 0);
  const glm::dvec3 upright(-sin_heading * sin_pitch, -cos_heading * sin_pitch, cos_pitch);
  const double sin_roll = std::sin(options.roll_rad);
  const double cos_roll = std::cos(options.roll_rad);
  right_ = level * cos_roll - upright * sin_roll;
  up_ = upright * cos_roll + level * sin_roll;
}

void Camera::lay_on_circle() {
  const double around_px = 2 * kPi / per_px_;
  const double whole_px = std::round(around_px);
  if (whole_px > kLargestSide_px || std::abs(around_px - whole_px) > kWhole * whole_px) return;
  circle_px_ = static_cast<int>(whole_px);
  per_px_ = 2 * kPi / whole_px;
  const double heading_px = std::remainder(options_.heading_rad, 2 * kPi) / per_px_;
  east_px_ = in_millionths(heading_px - middle_px_.x);
  east_px_ -= whole_px * std::floor(east_px_ / whole_px);
}

Camera Camera::part(const PixelRect& rect) const {
  Camera part = *this;
  part.options_.size_px = rect.size_px;
  part.first_px_ += rect.first_px;
  part.middle_px_ -= glm::dvec2(rect.first_px);
  if (circle_px_ > 0) {
    part.east_px_ += rect.first_px.x;
    part.east_px_ -= circle_px_ * std::floor(part.east_px_ / circle_px_);
  }
  return part;
}

double Camera::azimuth(double image_x_px) const {
  if (circle_px_ == 0) return options_.heading_rad + (image_x_px - middle_px_.x) * per_px_;
  // Exact, so that a place on the circle has one azimuth.
  double east_px = east_px_ + image_x_px;
  east_px -= circle_px_ * std::floor(east_px / circle_px_);
  return east_px * per_px_;
}

Ray Camera::ray(glm::dvec2 image_px) const {
  const double right_px = image_px.x - middle_px_.x;
  const double up_px = middle_px_.y - image_px.y;
  switch (options_.projection) {
    case Projection::perspective:
      return {{0, 0, 0}, forward_ + right_ * (right_px * per_px_) + up_ * (up_px * per_px_)};
    case Projection::cylindrical: {
      const double towards = azimuth(image_px.x);
      return {{0, 0, 0}, {std::sin(towards), std::cos(towards), up_px * per_px_}};
    }
    case Projection::orthographic:
      return {right_ * (right_px * per_px_) + up_ * (up_px * per_px_), forward_};
  }
  return {};
}

void Camera::aim_row(glm::dvec2 first_px, const DirectionSpans& directions) const {
  const std::size_t count = directions.x.size();
  if (options_.projection != Projection::perspective) {
    for (std::size_t i = 0; i < count; ++i) {
      const glm::dvec3 d = ray(first_px + glm::dvec2(static_cast<double>(i), 0)).direction;
      directions.x[i] = d.x;
      directions.y[i] = d.y;
      directions.z[i] = d.z;
    }
    return;
  }
  // Sums in the order of ray().
  lay({.first = forward_,
       .right = right_,
       .above = up_ * ((middle_px_.y - first_px.y) * per_px_),
       .from = first_px.x,
       .middle = middle_px_.x,
       .step = per_px_},
      directions);
}

std::optional<glm::dvec2> Camera::project(const glm::dvec3& point_m) const {
  const auto pixel = [&](double right_px, double up_px) {
    return glm::dvec2(middle_px_.x + right_px, middle_px_.y - up_px);
  };
  if (options_.projection == Projection::cylindrical) {
    const double ground_m = std::hypot(point_m.x, point_m.y);
    if (ground_m == 0) return std::nullopt;
    // Of its places a turn apart the one nearest to the image.
    const double half_px = options_.size_px.x / 2.0;
    const double aside =
        std::remainder(std::atan2(point_m.x, point_m.y) - azimuth(half_px), 2 * kPi);
    return glm::dvec2(half_px + aside / per_px_, pixel(0, point_m.z / ground_m / per_px_).y);
  }
  const double right_m = glm::dot(point_m, right_);
  const double up_m = glm::dot(point_m, up_);
  if (options_.projection == Projection::orthographic)
    return pixel(right_m / per_px_, up_m / per_px_);
  const double depth_m = glm::dot(point_m, forward_);
  if (!(depth_m > 0)) return std::nullopt;
  return pixel(right_m / depth_m / per_px_, up_m / depth_m / per_px_);
}

}  // namespace terrview

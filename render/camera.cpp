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

Camera::Camera(const CameraOptions& options) : options_(options) {
  check(options);
  per_px_ = size_of_pixel(options);
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

Ray Camera::ray(glm::dvec2 image_px) const {
  const glm::dvec2 size(options_.size_px);
  const double right_px = image_px.x - size.x / 2;
  const double up_px = size.y / 2 - image_px.y;
  switch (options_.projection) {
    case Projection::perspective:
      return {{0, 0, 0}, forward_ + right_ * (right_px * per_px_) + up_ * (up_px * per_px_)};
    case Projection::cylindrical: {
      const double azimuth = options_.heading_rad + right_px * per_px_;
      return {{0, 0, 0}, {std::sin(azimuth), std::cos(azimuth), up_px * per_px_}};
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
  const glm::dvec2 size(options_.size_px);
  lay({.first = forward_,
       .right = right_,
       .above = up_ * ((size.y / 2 - first_px.y) * per_px_),
       .from = first_px.x,
       .middle = size.x / 2,
       .step = per_px_},
      directions);
}

std::optional<glm::dvec2> Camera::project(const glm::dvec3& point_m) const {
  const glm::dvec2 size(options_.size_px);
  const auto pixel = [&](double right_px, double up_px) {
    return glm::dvec2(size.x / 2 + right_px, size.y / 2 - up_px);
  };
  if (options_.projection == Projection::cylindrical) {
    const double ground_m = std::hypot(point_m.x, point_m.y);
    if (ground_m == 0) return std::nullopt;
    const double azimuth =
        std::remainder(std::atan2(point_m.x, point_m.y) - options_.heading_rad, 2 * kPi);
    return pixel(azimuth / per_px_, point_m.z / ground_m / per_px_);
  }
  const double right_m = glm::dot(point_m, right_);
  const double up_m = glm::dot(point_m, up_);
  if (options_.projection == Projection::orthographic)
    return pixel(right_m / per_px_, up_m / per_px_);
  const double depth_m = glm::dot(point_m, forward_);
  if (!(depth_m > 0)) return std::nullopt;
  return pixel(right_m / depth_m / per_px_, up_m / depth_m / per_px_);
}

PixelLattice pixel_centres(const Camera& camera) { return {.count = camera.options().size_px}; }

std::optional<ColumnView> column_view(const Camera& camera, const PixelLattice& lattice) {
  const CameraOptions& options = camera.options();
  if (options.projection == Projection::orthographic || options.pitch_rad != 0 ||
      options.roll_rad != 0)
    return std::nullopt;
  ColumnView view;
  for (int column = 0; column < lattice.count.x; ++column)
    view.across.emplace_back(camera.ray(lattice.at({column, 0})).direction);
  for (int row = 0; row < lattice.count.y; ++row)
    view.rise.push_back(camera.ray(lattice.at({0, row})).direction.z);
  return view;
}

}  // namespace terrview

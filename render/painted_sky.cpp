#include "render/painted_sky.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "terrain/square_sectors.h"

namespace terrview {
namespace {

constexpr int kSide_px = CloudPainter::kWindow_px;
// Colours of the horizon along each side of the square that stands for it.
constexpr int kColorsASide = 256;

bool has_pixels(const Camera& camera) {
  return camera.options().projection != Projection::orthographic;
}

}  // namespace

SkyCamera sky_camera(const Camera& camera) {
  const CameraOptions& options = camera.options();
  SkyCamera sky;
  sky.size_px = camera.whole_px();
  sky.middle_px = camera.middle_px() + glm::dvec2(camera.first_px());
  sky.cylindrical = options.projection == Projection::cylindrical;
  sky.focal_px =
      sky.cylindrical ? 1 / camera.per_px() : sky.size_px.x / 2.0 / std::tan(options.fov_rad / 2);
  sky.forward = camera.forward();
  sky.right = camera.right();
  sky.up = camera.up();
  return sky;
}

SkyCamera painted_camera(const Camera& camera) {
  SkyCamera sky = sky_camera(camera);
  if (camera.circle_px() == 0) return sky;
  sky.size_px.x = camera.circle_px();
  sky.middle_px.x = camera.circle_px() / 2.0;
  const double first_px = camera.east_px() - std::floor(camera.east_px());
  const double middle_rad = (first_px + sky.middle_px.x) * camera.per_px();
  sky.forward = {std::sin(middle_rad), std::cos(middle_rad), 0};
  sky.right = {std::cos(middle_rad), -std::sin(middle_rad), 0};
  return sky;
}

PaintedSky::PaintedSky(const SkyOptions& sky, const Camera& camera, bool cloud_shadows)
    : PaintedSky(sky, painted_camera(camera), has_pixels(camera), cloud_shadows) {}

PaintedSky::PaintedSky(const SkyOptions& sky, const SkyCamera& camera, bool has_pixels,
                       bool cloud_shadows)
    : camera_(camera),
      painter_(sky, camera_),
      has_pixels_(has_pixels),
      window_count_(has_pixels_ ? (camera_.size_px + (kSide_px - 1)) / kSide_px : glm::ivec2(0)),
      windows_(std::make_unique<Window[]>(static_cast<std::size_t>(window_count_.x) *
                                          static_cast<std::size_t>(window_count_.y))) {
  if (cloud_shadows && sky.clouds) shadows_.emplace(*sky.clouds, sky.clear.towards_sun);
  for (int side = 0; side < 4; ++side)
    for (int place = 0; place <= kColorsASide; ++place)
      horizon_.push_back(
          painter_.background(glm::dvec3(sector_edge(side, place, kColorsASide), 0)));
}

PaintedSky::~PaintedSky() = default;

std::shared_ptr<const PaintedSky> PaintedSky::mirrored(const SkyOptions& sky, const Camera& camera,
                                                       bool cloud_shadows) {
  SkyCamera below = painted_camera(camera);
  for (glm::dvec3* axis : {&below.forward, &below.right, &below.up}) axis->z = -axis->z;
  return std::shared_ptr<const PaintedSky>(
      new PaintedSky(sky, below, has_pixels(camera), cloud_shadows));
}

glm::vec3 PaintedSky::color(const glm::dvec3& direction) const {
  if (!has_pixels_) return painter_.clear_color(direction);
  const glm::dvec2 image_px = camera_.image_of(direction);
  // A ray through the picture's very edge may round to beyond it.
  const glm::ivec2 pixel =
      glm::clamp(glm::ivec2(glm::floor(image_px)), glm::ivec2(0), camera_.size_px - 1);
  const glm::ivec2 at = pixel / kSide_px;
  Window& window = windows_[static_cast<std::size_t>(at.y * window_count_.x + at.x)];
  std::call_once(window.painted, [&] { paint(at, window); });
  const glm::ivec2 inside = pixel - at * kSide_px;
  return window.colors[static_cast<std::size_t>(inside.y * window_size(at).x + inside.x)];
}

glm::vec3 PaintedSky::horizon_color(const glm::dvec3& direction) const {
  if (direction.x == 0 && direction.y == 0) return horizon_.front();
  const auto [side, place] = square_place(glm::dvec2(direction), kColorsASide);
  const int before = std::min(static_cast<int>(place), kColorsASide - 1);
  const auto i = static_cast<std::size_t>(side * (kColorsASide + 1) + before);
  return glm::mix(horizon_[i], horizon_[i + 1], static_cast<float>(place - before));
}

glm::ivec2 PaintedSky::window_size(const glm::ivec2& at) const {
  return glm::min(glm::ivec2(kSide_px), camera_.size_px - at * kSide_px);
}

void PaintedSky::paint(const glm::ivec2& at, Window& window) const {
  PixelWindow pixels{at * kSide_px, window_size(at), {}};
  pixels.wanted.assign(static_cast<std::size_t>(pixels.size_px.x * pixels.size_px.y), true);
  window.colors = painter_.paint(pixels);
}

}  // namespace terrview

#include "cli/impact/building_sight.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <glm/geometric.hpp>

#include "cli/interrupt.h"
#include "cli/objects_csv.h"
#include "render/objects/object_bounds.h"
#include "render/objects/scene_objects.h"
#include "render/render.h"

namespace terrview {
namespace {

constexpr double kPi = std::numbers::pi;

using Parts = std::vector<const Prism*>;

// The buildings' prisms: place_buildings() raises nothing else.
std::map<std::int32_t, Parts> parts_of(const PlacedObjects& placed, std::int32_t before) {
  std::map<std::int32_t, Parts> parts;
  for (std::size_t i = 0; i < placed.objects.size(); ++i)
    if (const auto* prism = dynamic_cast<const Prism*>(placed.objects[i].get()))
      if (placed.looks[i].id > before) parts[placed.looks[i].id].push_back(prism);
  return parts;
}

Box box_around(const Parts& parts) {
  std::vector<Box> boxes;
  for (const Prism* part : parts) boxes.push_back(part->bounds());
  return around(boxes);
}

// The angle between an axis and the corner furthest from it.
double spread_rad(const Box& box, const glm::dvec3& axis) {
  double spread = 0;
  for (const glm::dvec3& corner : corners_of(box))
    spread =
        std::max(spread, std::atan2(glm::length(glm::cross(corner, axis)), glm::dot(corner, axis)));
  return spread;
}

CameraOptions square(int rays_across, double fov_rad) {
  return {.fov_rad = fov_rad, .size_px = glm::ivec2(rays_across)};
}

// The six sides of a cube.
std::vector<Camera> all_round(int rays_across) {
  std::vector<Camera> cameras;
  for (int side = 0; side < 6; ++side) {
    CameraOptions options = square(rays_across, kPi / 2);
    if (side < 4)
      options.heading_rad = side * kPi / 2;
    else
      options.pitch_rad = side == 4 ? kPi / 2 : -kPi / 2;
    cameras.emplace_back(options);
  }
  return cameras;
}

// Cameras that together see all of the box, each direction once.
std::vector<Camera> cameras_around(const Box& box, int rays_across) {
  constexpr double kAskew_rad = 0.55;
  constexpr double kWidest_rad = kPi / 4;
  const glm::dvec3 middle_m = (box.lowest_m + box.highest_m) / 2.0;
  const double distance_m = glm::length(middle_m);
  const glm::dvec3 axis = distance_m > 0 ? middle_m / distance_m : glm::dvec3(0, 1, 0);
  const double spread = spread_rad(box, axis);
  if (spread > kWidest_rad) return all_round(rays_across);
  CameraOptions options = square(rays_across, 2 * spread);
  options.heading_rad = std::atan2(axis.x, axis.y);
  options.pitch_rad = std::asin(std::clamp(axis.z, -1.0, 1.0));
  options.roll_rad = kAskew_rad;
  return {Camera(options)};
}

void add_point(const ViewFrame& frame, const glm::dvec3& view_m, BuildingSight& sight) {
  const SeenPoint point{view_m, glm::length(frame.to_true_enu(view_m))};
  if (!sight.nearest || point.distance_m < sight.nearest->distance_m) sight.nearest = point;
  if (!sight.farthest || point.distance_m > sight.farthest->distance_m) sight.farthest = point;
}

void add_samples(const ViewFrame& frame, const Camera& camera, const Raster<PixelSample>& samples,
                 BuildingSight& sight) {
  for (int row = 0; row < samples.height_px(); ++row) {
    for (int column = 0; column < samples.width_px(); ++column) {
      const PixelSample& sample = samples.at(column, row);
      if (sample.object_id != sight.id) continue;
      sight.solid_angle_sr += pixel_solid_angle_sr(camera, {column, row});
      add_point(frame, sample.position_m, sight);
    }
  }
}

// What decides which surface a ray meets, and no light.
Scene without_light(Scene scene) {
  scene.light.casts_shadows = false;
  scene.air = {};
  scene.detail = nullptr;
  return scene;
}

}  // namespace

std::vector<BuildingSight> sights_of(const View& view, std::int32_t before,
                                     const SightOptions& options) {
  const Scene scene = without_light(view.scene);
  std::vector<BuildingSight> sights;
  for (const auto& [id, parts] : parts_of(view.objects.placed, before)) {
    check_interrupt();
    BuildingSight sight{.id = id};
    for (const Camera& camera : cameras_around(box_around(parts), options.rays_across)) {
      const Frame frame = render(scene, camera, {.threads = options.threads, .keep_samples = true});
      add_samples(view.frame, camera, frame.samples, sight);
    }
    sight.facade = facade_sight(scene, parts, {.threads = options.threads});
    for (const auto& point_m : {sight.facade.nearest_m, sight.facade.farthest_m})
      if (point_m) add_point(view.frame, *point_m, sight);
    sights.push_back(sight);
  }
  return sights;
}

}  // namespace terrview

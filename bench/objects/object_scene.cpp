#include "bench/objects/object_scene.h"

#include <cmath>
#include <memory>

#include <glm/geometric.hpp>

#include "bench/objects/uniform_random.h"
#include "render/objects/box.h"

namespace terrview {
namespace {

constexpr double kTown_m = 1000;

double extent_m(const City& city) { return std::sqrt(1000.0 * city.boxes); }

// How far the town of a coordinate is moved.
double moved_m(const City& city, double at_m) {
  return (city.apart - 1) * kTown_m * std::floor(at_m / kTown_m);
}

}  // namespace

double City::middle_m() const {
  const double at_m = extent_m(*this) / 2;
  return at_m + moved_m(*this, at_m);
}

Objects city_scene(const City& city) {
  UniformRandom random(7);
  Objects objects;
  for (int i = 0; i < city.boxes; ++i) {
    glm::dvec3 low(random(0, extent_m(city)), random(0, extent_m(city)), 0);
    low += glm::dvec3(moved_m(city, low.x), moved_m(city, low.y), 0);
    low.z = city.relief_m / 2 * (std::sin(low.x / 700) + std::sin(low.y / 900));
    const double width_m = random(6, 20);
    const double depth_m = random(6, 20);
    objects.push_back(
        std::make_shared<BoxObject>(Box{low, low + glm::dvec3(width_m, depth_m, random(3, 30))}));
  }
  return objects;
}

std::vector<Ray> view_rays(const ObjectView& view) {
  const glm::dvec3 ahead = glm::normalize(view.to_m - view.eye_m);
  const bool is_upright = std::abs(ahead.z) > 0.999;
  const glm::dvec3 right =
      glm::normalize(glm::cross(ahead, is_upright ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1)));
  const glm::dvec3 up = glm::cross(right, ahead);
  const double pixel = 2 * std::tan(view.width_rad / 2) / view.size_px.x;
  std::vector<Ray> rays;
  for (int y = 0; y < view.size_px.y; y += 4)
    for (int x = 0; x < view.size_px.x; x += 4)
      for (int i = 0; i < 16; ++i) {
        const double px = x + i % 4 + 0.5 - view.size_px.x / 2.0;
        const double py = y + i / 4 + 0.5 - view.size_px.y / 2.0;
        rays.push_back({view.eye_m, glm::normalize(ahead + pixel * (px * right - py * up))});
      }
  return rays;
}

std::vector<Ray> shadow_rays(const ObjectSet& set, const std::vector<Ray>& rays,
                             const glm::dvec3& to_sun, double lift_m) {
  std::vector<Ray> shadow;
  for (const Ray& ray : rays) {
    const auto hit = set.first_hit(ray);
    if (!hit || glm::dot(hit->surface.normal, to_sun) <= 0) continue;
    shadow.push_back({hit->surface.position_m + lift_m * hit->surface.normal, to_sun});
  }
  return shadow;
}

}  // namespace terrview

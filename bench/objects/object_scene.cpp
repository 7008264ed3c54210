#include "bench/objects/object_scene.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include <glm/geometric.hpp>

#include "render/objects/box.h"
#include "render/objects/sphere.h"

namespace terrview {
namespace {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double operator()(double low, double high) {
    // By hand, so that every library makes the same.
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }

 private:
  std::mt19937_64 engine_;
};

std::shared_ptr<const Object> box(const glm::dvec3& low, const glm::dvec3& extent) {
  return std::make_shared<BoxObject>(Box{low, low + extent});
}

}  // namespace

Objects sphere_scene() {
  Random random(1984);
  constexpr glm::dvec3 kExtent(100, 100, 50);
  Objects objects;
  while (objects.size() < 200) {
    const glm::dvec3 centre(random(0, kExtent.x), random(0, kExtent.y), random(0, kExtent.z));
    const glm::dvec3 room = glm::min(centre, kExtent - centre);
    const double radius = random(0, std::min({room.x, room.y, room.z}));
    objects.push_back(std::make_shared<Sphere>(centre, radius));
  }
  return objects;
}

Objects prism_scene() {
  Random random(1984);
  Objects objects;
  for (int row = 0; row < 15; ++row)
    for (int column = 0; column < 15; ++column)
      objects.push_back(box({10.0 * column, 10.0 * row, 0}, {6, 6, random(2, 20)}));
  return objects;
}

Objects terrain_prism_scene() {
  Random random(1984);
  Objects objects;
  while (objects.size() < 15)
    objects.push_back(box({random(30, 70), random(30, 70), random(0, 5)},
                          {random(1, 4), random(1, 4), random(2, 8)}));
  return objects;
}

double city_extent_m(int boxes) { return std::sqrt(1000.0 * boxes); }

Objects city_scene(int boxes, double relief_m) {
  Random random(7);
  const double extent_m = city_extent_m(boxes);
  Objects objects;
  for (int i = 0; i < boxes; ++i) {
    glm::dvec3 low(random(0, extent_m), random(0, extent_m), 0);
    low.z = relief_m / 2 * (std::sin(low.x / 700) + std::sin(low.y / 900));
    objects.push_back(box(low, {random(6, 20), random(6, 20), random(3, 30)}));
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

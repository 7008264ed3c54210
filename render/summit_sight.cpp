#include "render/summit_sight.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "render/objects/scene_objects.h"

namespace terrview {
namespace {

// Rays of one vertical plane. Where one meets ground, so do all that come before it, but for holes.
struct Fan {
  std::function<Ray(double at)> ray;
  double middle;  // the ray through the place
  double spread;  // the fan goes so far below and above it
  glm::dvec2 direction;
};

// Ground steeper than this within the reach of a place is not told from ground before it.
constexpr double kSteepest = 4;

// From the eye, by slope.
Fan eye_fan(const glm::dvec3& place_m, double reach_m) {
  const double distance_m = glm::length(glm::dvec2(place_m));
  const glm::dvec2 direction = glm::dvec2(place_m) / distance_m;
  return {[direction](double slope) {
            return Ray{{0, 0, 0}, {direction, slope}};
          },
          place_m.z / distance_m, kSteepest * reach_m / (distance_m - reach_m), direction};
}

// Parallel ones, by metres upwards; those of a plan are no fan.
std::optional<Fan> parallel_fan(const Camera& camera, const glm::dvec3& place_m, double reach_m) {
  constexpr double kLeastLevel = 0.01;
  const glm::dvec3 forward = camera.forward();
  const double level = glm::length(glm::dvec2(forward));
  if (level < kLeastLevel) return std::nullopt;
  const glm::dvec2 direction = glm::dvec2(forward) / level;
  const glm::dvec3 upright(-direction * forward.z, level);
  const glm::dvec3 origin_m = place_m - forward * glm::dot(place_m, forward);
  return Fan{[=](double up_m) {
               return Ray{origin_m + upright * up_m, forward};
             },
             0, kSteepest * reach_m, direction};
}

bool hidden_by_objects(const Scene& scene, const Ray& ray) {
  return scene.objects && scene.objects->set->stops(ray);
}

// The last ray of the fan that meets ground no further than the reach behind the place, so far.
std::optional<Ray> last_ray(const Terrain& terrain, const Fan& fan, glm::dvec2 place_m,
                            double reach_m) {
  constexpr int kSteps = 60;
  const auto limited = [&](double at) {
    Ray ray = fan.ray(at);
    const double level_m = glm::dot(place_m - glm::dvec2(ray.origin_m), fan.direction) + reach_m;
    ray.length_m = level_m * glm::length(ray.direction) / glm::length(glm::dvec2(ray.direction));
    return ray;
  };
  double low = fan.middle - fan.spread;
  double high = fan.middle + fan.spread;
  if (!terrain.occluded(limited(low)) || terrain.occluded(limited(high))) return std::nullopt;
  for (int step = 0; step < kSteps; ++step) {
    const double middle = 0.5 * (low + high);
    (terrain.occluded(limited(middle)) ? low : high) = middle;
  }
  return limited(low);
}

}  // namespace

double summit_reach_m(const Terrain& terrain, const Terrain::Ground& ground, glm::dvec2 ground_m) {
  constexpr double kPosts = 2;
  constexpr double kLeast_m = 30;
  const auto& layer = terrain.layers()[static_cast<std::size_t>(ground.grid)];
  const glm::dmat2 step_m = glm::inverse(layer.map->jacobian(ground_m));
  return std::max(kLeast_m, kPosts * std::max(glm::length(step_m[0]), glm::length(step_m[1])));
}

std::optional<glm::dvec3> seen_summit(const Scene& scene, const Camera& camera, glm::dvec2 ground_m,
                                      double reach_m) {
  const Terrain& terrain = *scene.terrain;
  const auto ground = terrain.ground_at(ground_m);
  if (!ground) return std::nullopt;
  const glm::dvec3 place_m(ground_m, terrain.frame().at(ground_m).z_m(ground->scene_height_m));
  const bool parallel = camera.options().projection == Projection::orthographic;
  const double depth_m =
      parallel ? glm::dot(place_m, camera.forward()) : glm::length(glm::dvec2(place_m));
  if (depth_m <= (parallel ? 0 : reach_m)) return std::nullopt;
  const auto fan = parallel ? parallel_fan(camera, place_m, reach_m) : eye_fan(place_m, reach_m);
  if (!fan) {  // a plan: nothing of the ground is hidden
    const Ray ray{place_m - camera.forward() * depth_m, camera.forward(), depth_m};
    return hidden_by_objects(scene, ray) ? std::nullopt : std::optional(place_m);
  }
  const auto ray = last_ray(terrain, *fan, ground_m, reach_m);
  const auto hit = ray ? terrain.first_hit(*ray) : std::nullopt;
  if (!hit) return std::nullopt;
  if (glm::dot(ground_m - glm::dvec2(hit->position_m), fan->direction) > reach_m)
    return std::nullopt;
  const Ray sight{ray->origin_m, ray->direction, hit->distance_m};
  return hidden_by_objects(scene, sight) ? std::nullopt : std::optional(hit->position_m);
}

double height_above_surroundings_m(const Terrain& terrain, glm::dvec2 ground_m) {
  constexpr int kRings = 5;
  constexpr int kAzimuths = 24;
  constexpr double kRadius_m = 2000;
  const auto top = terrain.ground_at(ground_m);
  if (!top) return 0;
  double sum_m = 0;
  int count = 0;
  for (int ring = 1; ring <= kRings; ++ring) {
    for (int i = 0; i < kAzimuths; ++i) {
      const double azimuth = 2 * std::numbers::pi * i / kAzimuths;
      const glm::dvec2 away(std::sin(azimuth), std::cos(azimuth));
      const auto ground = terrain.ground_at(ground_m + away * (kRadius_m * ring / kRings));
      if (!ground) continue;
      sum_m += ground->scene_height_m;
      ++count;
    }
  }
  return count > 0 ? top->scene_height_m - sum_m / count : 0;
}

}  // namespace terrview

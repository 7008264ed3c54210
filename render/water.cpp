#include "render/water.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/objects/level_plane.h"

namespace terrview {
namespace {

// What the places of hits are rounded by, as a share of their numbers.
constexpr double kRounding = 1e-9;

double size_of(const glm::dvec3& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

// How high a ray is over a level surface, along the ray: in z of the view frame.
class Clearance {
 public:
  Clearance(const VerticalFrame& frame, const Ray& ray, double scene_height_m)
      : frame_(frame),
        origin_m_(ray.origin_m),
        direction_(glm::normalize(ray.direction)),
        scene_height_m_(scene_height_m) {}

  [[nodiscard]] double at(double along_m) const {
    const glm::dvec3 point = origin_m_ + along_m * direction_;
    return point.z - frame_.at(glm::dvec2(point)).z_m(scene_height_m_);
  }

 private:
  const VerticalFrame& frame_;
  glm::dvec3 origin_m_;
  glm::dvec3 direction_;
  double scene_height_m_;
};

// Where the parabola through the ends and the middle of a span is lowest, which may be beside it;
// nullopt where it has no lowest point.
std::optional<double> lowest_of_parabola(const Clearance& clearance, double from_m, double to_m) {
  const double begin = clearance.at(from_m);
  const double middle = clearance.at(0.5 * (from_m + to_m));
  const double end = clearance.at(to_m);
  const double bend = begin - 2 * middle + end;
  if (!(bend > 0)) return std::nullopt;
  return from_m + (to_m - from_m) * (3 * begin - 4 * middle + end) / (4 * bend);
}

// Where a ray comes nearest to a level surface of the curved Earth, if that is before its end. A
// parabola is off by some 100 m of 400 km; one about its lowest point is not.
std::optional<double> lowest_before(const Clearance& clearance, double end_m) {
  constexpr double kDoubt = 1.0 / 64;
  const double doubt_m = kDoubt * end_m;
  const auto about_m = lowest_of_parabola(clearance, 0, end_m);
  if (!about_m || *about_m < -doubt_m || *about_m > end_m + doubt_m) return std::nullopt;
  const double near_m = std::clamp(*about_m, doubt_m, end_m - doubt_m);
  const auto lowest_m = lowest_of_parabola(clearance, near_m - doubt_m, near_m + doubt_m);
  if (!lowest_m || !(*lowest_m > 0 && *lowest_m < end_m)) return std::nullopt;
  return lowest_m;
}

// The zero between `above` and `below`, by false position (the Illinois rule).
double zero_between(const Clearance& clearance, double above, double below) {
  double at_above = clearance.at(above);
  double at_below = clearance.at(below);
  double previous = 0;
  constexpr int kMostSteps = 100;
  for (int step = 0; step < kMostSteps && below - above > kRounding * 1e-3 * below; ++step) {
    const double zero = above + (below - above) * (at_above / (at_above - at_below));
    if (!(zero > above && zero < below)) break;
    const double at_zero = clearance.at(zero);
    if (at_zero == 0) return zero;
    if (at_zero > 0) {
      above = zero;
      at_above = at_zero;
      if (previous > 0) at_below /= 2;
    } else {
      below = zero;
      at_below = at_zero;
      if (previous < 0) at_above /= 2;
    }
    previous = at_zero;
  }
  return std::min(below, above + (below - above) * (at_above / (at_above - at_below)));
}

// Beyond this a ray has left the terrain.
double end_of(const Terrain& terrain, const Ray& ray) {
  const glm::dvec3 direction = glm::normalize(ray.direction);
  const double reach_m = terrain.reach_m() + glm::length(glm::dvec2(ray.origin_m));
  double end_m = ray.length_m;
  const double level = glm::length(glm::dvec2(direction));
  if (level > 0) end_m = std::min(end_m, reach_m / level);
  if (direction.z < 0) {
    const double bottom_m =
        terrain.frame().at({reach_m, 0}).z_m(-terrain.height_bound_m()) - terrain.height_bound_m();
    end_m = std::min(end_m, std::max(0.0, ray.origin_m.z - bottom_m) / -direction.z);
  }
  return end_m;
}

// The hit of the water's surface over the ground there; nullopt where there is none.
std::optional<Hit> surface_hit(const Terrain& terrain, const Ray& ray, double along_m) {
  const glm::dvec3 position_m = ray.origin_m + along_m * glm::normalize(ray.direction);
  const auto ground = terrain.ground_at(glm::dvec2(position_m));
  if (!ground) return std::nullopt;
  return Hit{along_m, position_m, ground->grid, ground->cell, ground->uv};
}

// Puts water of that level before the ground that a ray meets; whether it did.
bool meet_level(const Terrain& terrain, const Ray& ray, double level_m, std::optional<Hit>& hit) {
  const VerticalFrame& frame = terrain.frame();
  if (hit) {
    const glm::dvec3& at_m = hit->position_m;
    const double rounding_m = kRounding * (size_of(at_m) + std::abs(frame.eye_height_m));
    const double height_m = frame.at(glm::dvec2(at_m)).scene_height_m(at_m.z);
    if (height_m <= level_m + rounding_m) {
      const auto along_m = descent_m(frame, ray, level_m, hit->distance_m);
      hit = along_m ? surface_hit(terrain, ray, *along_m) : hit;
      return hit.has_value();
    }
    if (frame.is_flat()) return false;
  }
  const double end_m = hit ? hit->distance_m : end_of(terrain, ray);
  const auto along_m = descent_m(frame, ray, level_m, end_m);
  if (!along_m) return false;
  const auto surface = surface_hit(terrain, ray, *along_m);
  if (!surface) return false;
  const auto bed = terrain.ground_at(glm::dvec2(surface->position_m));
  if (bed->scene_height_m > level_m) return false;
  hit = surface;
  return true;
}

bool meet_lake(const Water& water, const std::optional<Hit>& hit) {
  if (!hit || water.lakes.empty()) return false;
  const auto& lakes = water.lakes[static_cast<std::size_t>(hit->grid)];
  return lakes && lakes->contain(hit->cell, hit->uv);
}

}  // namespace

void meet_water(const Scene& scene, std::span<const Ray> rays, RayHits& hits) {
  if (!scene.water) return;
  const Water& water = *scene.water;
  hits.water.assign(rays.size(), 0);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const bool flooded =
        water.level_m && meet_level(*scene.terrain, rays[i], *water.level_m, hits.ground[i]);
    hits.water[i] = flooded || meet_lake(water, hits.ground[i]) ? 1 : 0;
  }
}

std::optional<double> descent_m(const VerticalFrame& frame, const Ray& ray, double scene_height_m,
                                double end_m) {
  const Clearance clearance(frame, ray, scene_height_m);
  const double begin = clearance.at(0);
  const double end = clearance.at(end_m);
  if (!(begin > 0)) return std::nullopt;
  if (end <= 0) return zero_between(clearance, 0, end_m);
  if (frame.is_flat()) return std::nullopt;
  const auto lowest_m = lowest_before(clearance, end_m);
  if (!lowest_m || clearance.at(*lowest_m) > 0) return std::nullopt;
  return zero_between(clearance, 0, *lowest_m);
}

MirroredRay mirrored(const Terrain& terrain, const Ray& ray, const Hit& hit) {
  const VerticalFrame& frame = terrain.frame();
  const glm::dvec2 ground_m(hit.position_m);
  const LevelPlane level =
      level_plane(frame, ground_m, frame.at(ground_m).scene_height_m(hit.position_m.z));
  const glm::dvec3 down = glm::normalize(level.direction(glm::normalize(ray.direction)));
  const double fall = std::min(down.z, 0.0);
  const glm::dvec2 away(down);
  const glm::dvec3 up(away, glm::dot(level.slope, away) - fall);
  return {terrain.leave(hit, up), -fall};
}

}  // namespace terrview

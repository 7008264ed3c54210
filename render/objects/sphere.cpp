#include "render/objects/sphere.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "render/objects/slab_ray.h"

namespace terrview {

Sphere::Sphere(const glm::dvec3& centre_m, double radius_m)
    : centre_m_(centre_m), radius_m_(radius_m), bounds_{centre_m - radius_m, centre_m + radius_m} {}

std::optional<SurfaceHit> Sphere::first_hit(const Ray& ray) const {
  const auto stretch = SlabRay(ray).within(bounds_);
  if (!stretch) return std::nullopt;
  // From the point nearest to the centre, so that a far origin costs no digits (Haines et al., Ray
  // Tracing Gems, 2019, chapter 7).
  const glm::dvec3 along = glm::normalize(ray.direction);
  const glm::dvec3 from_centre_m = ray.origin_m - centre_m_;
  const double nearest_m = -glm::dot(from_centre_m, along);
  const glm::dvec3 nearest = from_centre_m + nearest_m * along;
  const double discriminant = radius_m_ * radius_m_ - glm::dot(nearest, nearest);
  if (discriminant < 0) return std::nullopt;
  const double half_chord_m = std::sqrt(discriminant);
  double distance_m = nearest_m - half_chord_m;
  if (distance_m < 0) distance_m = nearest_m + half_chord_m;
  if (distance_m < 0 || distance_m > ray.length_m) return std::nullopt;
  // Rounding must not carry it out of the bounds.
  distance_m = std::clamp(distance_m, stretch->enter_m, stretch->leave_m);
  const glm::dvec3 position_m = ray.origin_m + distance_m * along;
  const glm::dvec3 outward = position_m - centre_m_;
  const bool is_point = outward == glm::dvec3(0);
  return SurfaceHit{distance_m, position_m, is_point ? -along : glm::normalize(outward), 0};
}

}  // namespace terrview

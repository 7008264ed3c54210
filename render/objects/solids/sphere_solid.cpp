#include "render/objects/solids/sphere_solid.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "render/objects/solids/check_size.h"
#include "render/objects/solids/crossing.h"

namespace terrview {

SphereSolid::SphereSolid(double radius_m) : radius_m_(radius_m) {
  check_size("sphere", "radius", radius_m);
}

Box SphereSolid::bounds() const { return {glm::dvec3(-radius_m_), glm::dvec3(radius_m_)}; }

void SphereSolid::append_crossings(const Line& line, Crossings& crossings) const {
  // From the point nearest to the centre, so that a far origin costs no digits (Haines et al., Ray
  // Tracing Gems, 2019, chapter 7).
  const double nearest = nearest_to(line, glm::dvec3(0));
  const glm::dvec3 foot_m = line.origin_m + nearest * line.direction;
  const double half2_m2 = radius_m_ * radius_m_ - glm::dot(foot_m, foot_m);
  if (!(half2_m2 > 0)) return;
  const double half = std::sqrt(half2_m2 / glm::dot(line.direction, line.direction));
  const auto normal_at = [&](double t, int /*surface*/) {
    return glm::normalize(foot_m + (t - nearest) * line.direction);
  };
  append_range(line, {nearest - half, nearest + half, 0, 0}, radius_m_, normal_at, crossings);
}

}  // namespace terrview

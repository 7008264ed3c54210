#include "render/objects/solids/solid_object.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include <glm/geometric.hpp>

#include "render/objects/slab_ray.h"
#include "render/objects/solids/crossing.h"
#include "terrain/error.h"

namespace terrview {

SolidObject::SolidObject(SolidPtr solid) : solid_(std::move(solid)), bounds_(solid_->bounds()) {
  for (int axis = 0; axis < 3; ++axis) {
    const double low_m = bounds_.lowest_m[axis];
    const double high_m = bounds_.highest_m[axis];
    if (low_m > high_m)
      throw InputError("solid: nothing is left of it: move the solids that it intersects together");
    if (!std::isfinite(low_m) || !std::isfinite(high_m))
      throw InputError("solid: it reaches to infinity: intersect it with a box");
  }
  // What positions on a ray lose to rounding.
  const double slack_m =
      kLostDigits * (sum_of_sizes(bounds_.lowest_m) + sum_of_sizes(bounds_.highest_m));
  bounds_.lowest_m -= slack_m;
  bounds_.highest_m += slack_m;
}

std::optional<SurfaceHit> SolidObject::first_hit(const Ray& ray) const {
  const auto stretch = SlabRay(ray).within(bounds_);
  if (!stretch) return std::nullopt;
  std::array<std::byte, 8192> room;
  std::pmr::monotonic_buffer_resource memory(room.data(), room.size());
  Crossings crossings(&memory);
  crossings.reserve(32);
  const Line line{ray.origin_m, glm::normalize(ray.direction)};
  solid_->append_crossings(line, crossings);
  const auto first = std::ranges::find_if(crossings, [](const Crossing& c) { return c.t >= 0; });
  if (first == crossings.end() || first->t > ray.length_m) return std::nullopt;
  // Rounding must not carry it out of the bounds.
  const double distance_m = std::clamp(first->t, stretch->enter_m, stretch->leave_m);
  return SurfaceHit{distance_m, line.origin_m + distance_m * line.direction, first->normal,
                    first->part};
}

}  // namespace terrview

#include "terrain/sight_tracer.h"

#include <algorithm>
#include <cmath>

#include "terrain/eye_tracer.h"
#include "terrain/tracer.h"

namespace terrview {
namespace {

// How near to the end of a ray, as a share of its length, a hit leaves in doubt whether it is
// before it.
constexpr double kDoubt = 1e-6;

}  // namespace

SightTracer::SightTracer(const Terrain& terrain)
    : terrain_(terrain), may_come_below_(terrain.has_holes() || !terrain.ground_at({0, 0})) {
  if (EyeFront::serves(terrain)) front_.emplace(terrain, EyeFrontOptions{});
}

void SightTracer::trace(std::span<const Ray> rays, std::span<std::uint8_t> stopped) const {
  if (!front_) {
    for (std::size_t i = 0; i < rays.size(); ++i) stopped[i] = terrain_.occluded(rays[i]) ? 1 : 0;
    return;
  }
  for (std::size_t first = 0; first < rays.size(); first += EyeRays::kMost) {
    const std::size_t count = std::min(EyeRays::kMost, rays.size() - first);
    trace_few(rays.subspan(first, count), stopped.subspan(first, count));
  }
}

void SightTracer::trace_few(std::span<const Ray> rays, std::span<std::uint8_t> stopped) const {
  EyeRays on;
  on.count = rays.size();
  for (std::size_t i = 0; i < rays.size(); ++i) on.aim(i, rays[i].direction);
  TraceCounts counts;
  terrview::trace(*front_, on, counts);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const double end_m = rays[i].length_m / metres_per_g(on.slope[i]);
    const bool in_doubt =
        !on.is_hit(i) ? may_come_below_ : !(std::abs(on.ground_m[i] - end_m) > kDoubt * end_m);
    stopped[i] =
        (in_doubt ? terrain_.occluded(rays[i]) : on.is_hit(i) && on.ground_m[i] < end_m) ? 1 : 0;
  }
}

}  // namespace terrview

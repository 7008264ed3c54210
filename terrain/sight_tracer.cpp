#include "terrain/sight_tracer.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "terrain/eye_tracer.h"
#include "terrain/grid_walk.h"
#include "terrain/tracer.h"
#include "terrain/track_piece.h"

namespace terrview {
namespace {

// How near to the end of a ray, as a share of its length or of a cell, a hit leaves in doubt
// whether it is before it.
constexpr double kDoubt = 1e-6;

// Whether a ray that goes on may be clear of ground which it meets where it ends: inside a cell,
// the surface of a whole line is a chord over the cell, and that under an end is the cell's own.
bool ends_at_ground(const Terrain& terrain, const Ray& ray) {
  constexpr double kRounding = 1e-9;
  const TerrainLayer& layer = terrain.layers()[0];
  const glm::dvec3 end_m = glm::normalize(ray.direction) * ray.length_m;
  const glm::dvec2 ground_m(end_m);
  const double g_m = glm::length(ground_m);
  const glm::dvec2 uv = track_point(*layer.map, ground_m / g_m, g_m).uv;
  const double height_m = height_at(*layer.grid, terrain.model(), cell_of(*layer.grid, uv), uv) *
                          terrain.frame().z_scale;
  const double scale_m =
      terrain.height_bound_m() + std::abs(terrain.frame().eye_height_m) + ray.length_m;
  return !(end_m.z - terrain.frame().at(ground_m).z_m(height_m) > kRounding * scale_m);
}

}  // namespace

SightTracer::SightTracer(const Terrain& terrain)
    : terrain_(terrain), may_come_below_(terrain.has_holes() || !terrain.ground_at({0, 0})) {
  if (!EyeFront::serves(terrain)) return;
  front_.emplace(terrain, EyeFrontOptions{});
  const glm::dmat2 to_ground = glm::inverse(terrain.layers()[0].map->jacobian({0, 0}));
  doubt_m_ = kDoubt * (glm::length(to_ground[0]) + glm::length(to_ground[1]));
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
    const bool is_stopped = on.is_hit(i) && on.ground_m[i] < end_m;
    const bool in_doubt =
        (on.is_hit(i) ? !(std::abs(on.ground_m[i] - end_m) > kDoubt * end_m + doubt_m_)
                      : may_come_below_) ||
        (!is_stopped && ends_at_ground(terrain_, rays[i]));
    stopped[i] = (in_doubt ? terrain_.occluded(rays[i]) : is_stopped) ? 1 : 0;
  }
}

}  // namespace terrview

#include "render/lines/line_tracer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "render/meet.h"
#include "render/objects/scene_objects.h"
#include "render/pixel_tracer.h"
#include "render/view_front.h"
#include "render/water.h"

namespace terrview {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Of a gap between unlike things; one of 1 or more is a gap.
constexpr double kUnlike = 1e6;

}  // namespace

LineTracer::LineTracer(const Scene& scene, const Camera& camera)
    : scene_(scene), camera_(camera), front_(view_front(*scene.terrain, camera)) {
  for (const TerrainLayer& layer : scene.terrain->layers()) {
    const glm::dmat2 step_m = glm::inverse(layer.map->jacobian({0, 0}));
    post_m_.push_back(std::max(glm::length(step_m[0]), glm::length(step_m[1])));
  }
}

LinePoint LineTracer::at(glm::dvec2 image_px) const { return at(std::span(&image_px, 1)).front(); }

std::vector<LinePoint> LineTracer::at(std::span<const glm::dvec2> image_px) const {
  std::vector<Ray> rays;
  rays.reserve(image_px.size());
  for (const glm::dvec2& point : image_px) rays.push_back(camera_.ray(point));
  TraceCounts traced;
  ObjectCounts met;
  RayHits hits{.ground = trace_rays(*scene_.terrain, front_.get(), rays, traced)};
  meet_water(scene_, rays, hits);
  meet_objects(scene_, rays, hits, met);
  std::vector<LinePoint> points(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i) {
    LinePoint& point = points[i];
    if (hits.meets_object(i)) {
      const ObjectHit& hit = *hits.objects[i];
      point.thing = scene_.objects->looks[static_cast<std::size_t>(hit.object)].id;
      point.distance_m = hit.surface.distance_m;
      point.normal = hit.surface.normal;
    } else if (hits.ground[i]) {
      const Hit& hit = *hits.ground[i];
      const std::int32_t thing = hits.meets_water(i) ? LinePoint::kWater : LinePoint::kGround;
      point = {thing, hit.grid, hit.distance_m, hit.uv, {0, 0, 0}};
    } else {
      point.distance_m = kInfinity;
    }
  }
  return points;
}

double LineTracer::gap(const LinePoint& a, const LinePoint& b) const {
  constexpr double kPosts = 2.0 / 3;
  constexpr double kShare = 0.02 / 3;
  constexpr double kObject_m = 0.5;
  constexpr double kCrease = 0.34729635533386066;  // 2 sin(10 degrees)
  if (a.thing != b.thing) return kUnlike;
  if (a.thing == LinePoint::kSky) return 0;
  const double near_m = std::min(a.distance_m, b.distance_m);
  const double jump_m = std::abs(a.distance_m - b.distance_m);
  if (a.thing <= LinePoint::kGround)
    return jump_m / std::max(kPosts * post_m(a.grid), kShare * near_m);
  return std::max(jump_m / std::max(kObject_m, kShare * near_m),
                  glm::distance(a.normal, b.normal) / kCrease);
}

std::optional<LineCrossing> LineTracer::crossing(glm::dvec2 first_px, const LinePoint& first,
                                                 glm::dvec2 second_px,
                                                 const LinePoint& second) const {
  constexpr int kSteps = 14;
  LineCrossing found{{}, first, second, gap(first, second)};
  if (found.gap < 1) return std::nullopt;
  double low = 0;
  double high = 1;
  const auto place = [&](double share) { return first_px + share * (second_px - first_px); };
  for (int step = 0; step < kSteps; ++step) {
    const double middle = 0.5 * (low + high);
    const LinePoint between = at(place(middle));
    const double before = gap(found.first, between);
    const double behind = gap(between, found.second);
    found.gap = std::max(before, behind);
    if (found.gap < 1) return std::nullopt;
    (before >= behind ? high : low) = middle;
    (before >= behind ? found.second : found.first) = between;
  }
  found.at_px = place(0.5 * (low + high));
  return found;
}

double LineTracer::px_per_m(double distance_m) const {
  const bool parallel = camera_.options().projection == Projection::orthographic;
  return 1 / (camera_.per_px() * (parallel ? 1 : distance_m));
}

}  // namespace terrview

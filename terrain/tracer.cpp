#include "terrain/tracer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "terrain/grid_walk.h"

namespace terrview {
namespace {

// A ray this near to the vertical moves sideways by less than rounding.
constexpr double kVertical = 1e-12;

// Where `line` leaves the disc of `reach_m` about the eye; negative if it never enters it.
double leaves_disc_m(const GroundLine& line, double reach_m) {
  const double along = glm::dot(line.origin_m, line.direction);
  const double away2 = glm::dot(line.origin_m, line.origin_m) - reach_m * reach_m;
  const double discriminant = along * along - away2;
  if (discriminant < 0) return -1;
  return -along + std::sqrt(discriminant);
}

// The first root in [0, 1] of above + (below - above) t + bend t (1 - t) where it turns negative,
// above >= 0; 2 if none. Of the two forms of the root, each where it loses no digits.
double first_root(double above, double below, double bend) {
  if (bend == 0) return below <= 0 ? above / (above - below) : 2;
  const double b = below - above + bend;
  const double discriminant = b * b + 4 * bend * above;
  if (discriminant < 0) return below <= 0 ? 1 : 2;
  const double root_term = std::sqrt(discriminant);
  double root = 2;
  if (b < 0) root = 2 * above / (root_term - b);
  if (b >= 0 && bend > 0) root = (b + root_term) / (2 * bend);
  return below <= 0 ? std::min(root, 1.0) : (root <= 1 ? root : 2);
}

// The walk of one ray, which is z = z0 + slope * g over its ground line.
class Tracer {
 public:
  Tracer(const Terrain& terrain, double ceiling_m, const Ray& ray)
      : terrain_(terrain),
        ceiling_m_(ceiling_m),
        ray_(ray),
        run_(glm::length(glm::dvec2(ray.direction))),
        line_{glm::dvec2(ray.origin_m), glm::dvec2(ray.direction) / run_},
        slope_(ray.direction.z / run_) {}

  Trace run() {
    const double end_m = std::min(leaves_disc_m(line_, terrain_.reach_m()), ray_.length_m * run_);
    if (end_m >= 0) walk_layer(0, 0, end_m);
    return trace_;
  }

 private:
  [[nodiscard]] double ray_z(double g_m) const { return ray_.origin_m.z + slope_ * g_m; }

  // Walks layer `index`, and the layers after it where it has no ground. False: the ray is stopped
  // or can meet nothing more.
  bool walk_layer(std::size_t index, double from_m, double to_m) {
    if (index == terrain_.layers().size()) {
      on_ground_ = false;
      return true;
    }
    const TerrainLayer& layer = terrain_.layers()[index];
    GridWalk walk(*layer.grid, *layer.map, terrain_.model(), line_, from_m, to_m);
    Span span;
    double covered_m = from_m;
    while (walk.next(span)) {
      const bool is_free = slope_ >= 0 && ray_z(span.in.g_m) > ceiling_m_;
      if (is_free && index + 1 == terrain_.layers().size()) return false;
      if (!span.has_ground) continue;
      if (span.in.g_m > covered_m && !walk_layer(index + 1, covered_m, span.in.g_m)) return false;
      if (is_free) return false;
      if (!cross_span(static_cast<int>(index), span)) return false;
      covered_m = span.out.g_m;
    }
    return covered_m >= to_m || walk_layer(index + 1, covered_m, to_m);
  }

  // How far the ray is above the surface at a crossing.
  double clearance(const Crossing& crossing) {
    const VerticalFrame& frame = terrain_.frame();
    return ray_z(crossing.g_m) -
           frame.at(line_.at(crossing.g_m)).z_m(frame.z_scale * crossing.height_m);
  }

  bool cross_span(int grid, const Span& span) {
    const bool continues = on_ground_ && grid == grid_of_last_ && span.in.g_m == last_m_;
    const double in = continues ? last_clearance_ : clearance(span.in);
    const double out = clearance(span.out);
    ++trace_.tests;
    const bool was_on_ground = on_ground_ && span.in.g_m == last_m_;
    on_ground_ = true;
    grid_of_last_ = grid;
    last_m_ = span.out.g_m;
    last_clearance_ = out;

    if (in < 0 && !was_on_ground) {
      trace_.outcome = Outcome::below;
      return false;
    }
    // Coming from ground that it was above, a ray below this ground meets the step between them.
    if (in < 0 || (in == 0 && out <= 0)) return stop(grid, span, 0);
    const double share = first_root(in, out, bend(span));
    return share > 1 || stop(grid, span, share);
  }

  [[nodiscard]] double bend(const Span& span) const {
    if (span.sag_m == 0) return 0;
    const VerticalFrame& frame = terrain_.frame();
    const double slope = frame.at(line_.at(span.in.g_m)).slope(frame.z_scale * span.in.height_m);
    return slope * frame.z_scale * span.sag_m;
  }

  bool stop(int grid, const Span& span, double share) {
    const double g_m = span.in.g_m + share * (span.out.g_m - span.in.g_m);
    const double distance_m = g_m / run_;
    trace_.outcome = Outcome::hit;
    trace_.hit = {distance_m, glm::dvec3(line_.at(g_m), ray_z(g_m)), grid, span.cell,
                  span.in.uv + share * (span.out.uv - span.in.uv)};
    return false;
  }

  const Terrain& terrain_;
  double ceiling_m_;
  const Ray& ray_;
  double run_;  // ground metres per metre of ray
  GroundLine line_;
  double slope_;
  Trace trace_;
  // The end of the last span over ground.
  bool on_ground_ = false;
  int grid_of_last_ = -1;
  double last_m_ = 0;
  double last_clearance_ = 0;
};

Trace trace_vertical(const Terrain& terrain, const Ray& ray) {
  const auto ground = terrain.ground_at(glm::dvec2(ray.origin_m));
  if (!ground) return {};
  const double z_m = terrain.frame().at(glm::dvec2(ray.origin_m)).z_m(ground->scene_height_m);
  const double clearance_m = ray.origin_m.z - z_m;
  if (clearance_m < 0) return {Outcome::below, {}, 1};
  if (ray.direction.z > 0 || clearance_m > ray.length_m) return {};
  const glm::dvec3 position(ray.origin_m.x, ray.origin_m.y, z_m);
  return {Outcome::hit, {clearance_m, position, ground->grid, ground->cell, ground->uv}, 1};
}

}  // namespace

Trace trace(const Terrain& terrain, double ceiling_m, const Ray& ray) {
  if (glm::length(glm::dvec2(ray.direction)) < kVertical) return trace_vertical(terrain, ray);
  return Tracer(terrain, ceiling_m, ray).run();
}

}  // namespace terrview

#include "terrain/tracer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "terrain/grid_walk.h"

namespace terrview {
namespace {

// A ray this near to the vertical moves sideways by less than rounding.
constexpr double kVertical = 1e-12;

constexpr int kNoGrid = -1;

// Larger than the rounding of a clearance, as a share of the numbers it comes from.
constexpr double kRounding = 1e-12;

// Where the search of a layer's pyramid stands.
struct BlockSearch {
  int level = HeightFloors::kFirstLevel - 1;  // of the last block skipped
  glm::ivec2 met{-1, -1};                     // the block of the first level being walked
};

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
  Tracer(const Terrain& terrain, double ceiling_m, const Ray& ray, double clear_m)
      : terrain_(terrain),
        ceiling_m_(ceiling_m),
        ray_(ray),
        clear_m_(clear_m),
        line_(ground_line(ray)),
        slope_(ray_slope(ray)),
        metres_per_g_(metres_per_g(slope_)) {}

  Trace run() {
    const double end_m =
        std::min(leaves_disc_m(line_, terrain_.reach_m()), ray_.length_m / metres_per_g_);
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
    BlockSearch search;
    Span span;
    double covered_m = from_m;
    const auto cover_gap = [&](double until_m) {
      return until_m <= covered_m || walk_layer(index + 1, covered_m, until_m);
    };
    while (walk.over_grid()) {
      if (slope_ >= 0 && ray_z(walk.position_m()) > ceiling_m_) {
        static_cast<void>(cover_gap(walk.position_m()));
        return false;
      }
      if (const auto exit = clear_block(index, walk, search, to_m)) {
        if (!cover_gap(walk.position_m())) return false;
        walk.skip(search.level, *exit);
        // A block without holes is ground that the ray is above.
        on_ground_ = true;
        grid_of_last_ = kNoGrid;
        covered_m = last_m_ = exit->g_m;
        continue;
      }
      if (!walk.next(span)) break;
      if (span.out.g_m < clear_m_) {
        pass(span);
        covered_m = span.out.g_m;
        continue;
      }
      if (!span.has_ground) continue;
      if (!cover_gap(span.in.g_m)) return false;
      if (!cross_span(static_cast<int>(index), span)) return false;
      covered_m = span.out.g_m;
    }
    return covered_m >= to_m || walk_layer(index + 1, covered_m, to_m);
  }

  // The exit of the largest block ahead, up to one level above the last, that the ray clears.
  std::optional<GridWalk::BlockExit> clear_block(std::size_t index, GridWalk& walk,
                                                 BlockSearch& search, double to_m) {
    if (!terrain_.skips_blocks()) return std::nullopt;
    constexpr int kFirst = HeightFloors::kFirstLevel;
    const glm::ivec2 block(walk.cell().x >> kFirst, walk.cell().y >> kFirst);
    if (block == search.met) return std::nullopt;
    search.level = std::min(search.level + 1, terrain_.layers()[index].ceilings->last_level());
    for (; search.level >= kFirst; --search.level) {
      ++trace_.counts.nodes;
      const auto exit = walk.block_exit(search.level);
      if (!exit || exit->g_m >= to_m) continue;
      if (exit->g_m < clear_m_ ||
          clears(range_of(index, search.level, walk.cell()), walk.position_m(), exit->g_m))
        return exit;
    }
    search.met = block;
    return std::nullopt;
  }

  [[nodiscard]] HeightRange range_of(std::size_t index, int level, glm::ivec2 cell) const {
    const float highest_m = terrain_.layers()[index].ceilings->highest_m(level, cell);
    const HeightFloors* floors = terrain_.floors(index);
    const float lowest_m = floors ? floors->lowest_m(level, cell) : highest_m;
    return {lowest_m, highest_m, floors && std::isinf(lowest_m)};
  }

  // Whether the ray stays above everything in a block between two points of its line. Errs only in
  // saying no.
  [[nodiscard]] bool clears(const HeightRange& range, double from_m, double to_m) const {
    // Another layer may fill the holes.
    if (range.has_holes && terrain_.layers().size() > 1) return false;
    if (std::isinf(range.highest_m)) return true;
    // Bands end at holes, which only the walk finds.
    if (range.has_holes && terrain_.model() == SurfaceModel::band) return false;
    const VerticalFrame& frame = terrain_.frame();
    const double highest_m = frame.z_scale * range.highest_m;
    const double ceiling_m = frame.ceiling_between(highest_m, line_.at(from_m), line_.at(to_m));
    const double lowest_ray_m = std::min(ray_z(from_m), ray_z(to_m));
    double slack_m = kRounding * (std::abs(highest_m) + std::abs(frame.eye_height_m) +
                                  std::abs(ray_.origin_m.z) + std::abs(lowest_ray_m));
    if (terrain_.model() == SurfaceModel::bilinear) slack_m += parabola_slack_m(range);
    return lowest_ray_m > ceiling_m + slack_m;
  }

  // The parabola of a bilinear patch takes dz/dh from one end of the span: where it bulges, it may
  // be higher than its heights by their difference times that of the slopes.
  [[nodiscard]] double parabola_slack_m(const HeightRange& range) const {
    const VerticalFrame& frame = terrain_.frame();
    if (frame.is_flat()) return 0;
    // How low the ground of a block with holes lies is not known.
    if (range.has_holes) return std::numeric_limits<double>::infinity();
    const double lowest_m = frame.z_scale * range.lowest_m;
    const double highest_m = frame.z_scale * range.highest_m;
    const auto slopes = frame.slopes(lowest_m, highest_m, terrain_.reach_m());
    return (slopes.most - slopes.least) * (highest_m - lowest_m);
  }

  // How far the ray is above the surface at a crossing.
  double clearance(const GridCrossing& crossing) {
    const VerticalFrame& frame = terrain_.frame();
    return ray_z(crossing.g_m) -
           frame.at(line_.at(crossing.g_m)).z_m(frame.z_scale * crossing.height_m);
  }

  // Takes it as known that the ray is above a span.
  void pass(const Span& span) {
    on_ground_ = span.has_ground;
    grid_of_last_ = kNoGrid;
    last_m_ = span.out.g_m;
  }

  bool cross_span(int grid, const Span& span) {
    const bool continues = on_ground_ && grid == grid_of_last_ && span.in.g_m == last_m_;
    const double in = continues ? last_clearance_ : clearance(span.in);
    const double out = clearance(span.out);
    ++trace_.counts.tests;
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
    if (in < 0) return stop(grid, span, 0);
    // Through a post the walk takes a step of no length, where a ray from the ground is still on
    // it.
    if (span.in.g_m == span.out.g_m) return true;
    if (in == 0 && out <= 0) return stop(grid, span, 0);
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
    const double distance_m = g_m * metres_per_g_;
    trace_.outcome = Outcome::hit;
    trace_.ground_m = g_m;
    const glm::dvec2 uv = span.in.uv + share * (span.out.uv - span.in.uv);
    const glm::ivec2 cell =
        glm::clamp(glm::ivec2(glm::floor(uv)), glm::min(span.cell, span.last_cell),
                   glm::max(span.cell, span.last_cell));
    trace_.hit = {distance_m, glm::dvec3(line_.at(g_m), ray_z(g_m)), grid, cell, uv};
    return false;
  }

  const Terrain& terrain_;
  double ceiling_m_;
  const Ray& ray_;
  double clear_m_;
  GroundLine line_;
  double slope_;         // dz / dg
  double metres_per_g_;  // along the ray, per metre of ground
  Trace trace_;
  // The end of the last span over ground.
  bool on_ground_ = false;
  int grid_of_last_ = kNoGrid;
  double last_m_ = 0;
  double last_clearance_ = 0;
};

Trace trace_vertical(const Terrain& terrain, const Ray& ray) {
  const auto ground = terrain.ground_at(glm::dvec2(ray.origin_m));
  if (!ground) return {};
  const double z_m = terrain.frame().at(glm::dvec2(ray.origin_m)).z_m(ground->scene_height_m);
  const double clearance_m = ray.origin_m.z - z_m;
  if (clearance_m < 0) return {Outcome::below, {}, 0, {.tests = 1}};
  if (ray.direction.z > 0 || clearance_m > ray.length_m) return {};
  const glm::dvec3 position(ray.origin_m.x, ray.origin_m.y, z_m);
  return {Outcome::hit,
          {clearance_m, position, ground->grid, ground->cell, ground->uv},
          0,
          {.tests = 1}};
}

}  // namespace

double leaves_disc_m(const GroundLine& line, double reach_m) {
  const double along = glm::dot(line.origin_m, line.direction);
  const double away2 = glm::dot(line.origin_m, line.origin_m) - reach_m * reach_m;
  const double discriminant = along * along - away2;
  if (discriminant < 0) return -1;
  return -along + std::sqrt(discriminant);
}

double metres_per_g(double slope) { return std::sqrt(1 + slope * slope); }

double ray_slope(const Ray& ray) {
  return ray.direction.z * (1 / glm::length(glm::dvec2(ray.direction)));
}

bool is_vertical(const Ray& ray) {
  return glm::length(glm::dvec2(ray.direction)) < kVertical * std::abs(ray.direction.z);
}

GroundLine ground_line(const Ray& ray) {
  const glm::dvec2 across(ray.direction);
  // One division serves both, and the slope.
  return {glm::dvec2(ray.origin_m), across * (1 / glm::length(across))};
}

Trace trace(const Terrain& terrain, double ceiling_m, const Ray& ray, double clear_m) {
  if (is_vertical(ray)) return trace_vertical(terrain, ray);
  return Tracer(terrain, ceiling_m, ray, clear_m).run();
}

}  // namespace terrview

#include "terrain/sun_field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "terrain/tracer.h"
#include "terrain/view_transform.h"

namespace terrview {
namespace {

// A sun whose rays rise by more over a metre of ground counts as in the zenith.
constexpr double kSteepest = 1000;

// Rays cross more lines than this times the posts they pass along them.
constexpr double kMostDrift = 1.4;

constexpr int kNodes = 33;

// A straight piece within kTrackError_cells of a track x(line) with |x''| <= b is shorter than
// sqrt(0.28 / b), for drifts up to kMostDrift, and turns from the track by less than this times
// sqrt(b), in posts over a line.
constexpr double kTurnOfBend = 0.4;

// What is next to the eye: where its blur is a larger share of a ray's rise.
constexpr double kEyeTurn = 0.005;

// The ground point of a place of the grid, by Newton's method from one nearby; NaN if not found.
glm::dvec2 ground_of(const GroundMap& map, glm::dvec2 uv, glm::dvec2 near_m) {
  constexpr int kSteps = 20;
  constexpr double kNear_posts = 1e-6;
  for (int i = 0; i < kSteps; ++i) {
    const glm::dvec2 off = uv - map.to_grid(near_m);
    if (glm::length(off) < kNear_posts) return near_m;
    near_m += glm::inverse(map.jacobian(near_m)) * off;
  }
  return glm::dvec2(std::numeric_limits<double>::quiet_NaN());
}

// A direction of the view frame in the grid, over a metre of ground.
struct GridDirection {
  glm::dvec2 posts;
  double rise;  // in the grid's unit of height
};

GridDirection in_grid(const Terrain& terrain, const glm::dvec3& at_m, const glm::dvec3& direction) {
  const VerticalFrame& frame = terrain.frame();
  const glm::dvec3 metre = direction / glm::length(glm::dvec2(direction));
  const glm::dvec2 posts = terrain.layers()[0].map->jacobian(glm::dvec2(at_m)) * glm::dvec2(metre);
  if (frame.is_flat()) return {posts, metre.z / frame.z_scale};
  const double half_post_m = 0.5 / glm::length(posts);
  const auto height_at = [&](double metres) {
    const glm::dvec3 point = at_m + metres * metre;
    return frame.at(glm::dvec2(point)).scene_height_m(point.z);
  };
  const double rise_m = (height_at(half_post_m) - height_at(-half_post_m)) / (2 * half_post_m);
  return {posts, rise_m / frame.z_scale};
}

// How far a ray goes until it is above all ground or leaves the disc where that lies.
double length_m(const Terrain& terrain, const glm::dvec3& from_m, const glm::dvec3& direction) {
  const double level = glm::length(glm::dvec2(direction));
  const glm::dvec2 range_m = terrain.height_range_m();
  const double to_sky_m = 2 * (range_m.y - range_m.x) / std::max(direction.z, 1e-9 * level);
  const GroundLine line{glm::dvec2(from_m), glm::dvec2(direction) / level};
  return std::min(to_sky_m, std::max(0.0, leaves_disc_m(line, terrain.reach_m())) / level);
}

}  // namespace

SunRates SunRates::with(const SunRates& other) const {
  const double least = std::min(drift - spread, other.drift - other.spread);
  const double most = std::max(drift + spread, other.drift + other.spread);
  return {(least + most) / 2, (most - least) / 2, std::min(rise_least, other.rise_least),
          std::max(rise_most, other.rise_most)};
}

SunField::SunField(const Terrain& terrain, const glm::dvec3& to_sun)
    : linear_(terrain.layers()[0].map->linear() && terrain.frame().is_flat()),
      nodes_(linear_ ? 2 : kNodes) {
  orient(terrain, to_sun);
  if (!regular_) return;
  fill_lattice(terrain, to_sun);
  if (regular_) widen_between_nodes();
  if (regular_) blur_the_eye(terrain);
}

void SunField::orient(const Terrain& terrain, const glm::dvec3& to_sun) {
  const TerrainLayer& layer = terrain.layers()[0];
  const glm::dvec2 middle = glm::dvec2(layer.grid->columns - 1, layer.grid->rows - 1) / 2.0;
  const glm::dvec2 ground_m = ground_of(*layer.map, middle, {0, 0});
  const glm::dvec3 at_m(ground_m, terrain.frame().at(ground_m).z_m(0));
  const glm::dvec2 posts =
      in_grid(terrain, at_m, direction_at(terrain.frame(), at_m, to_sun)).posts;
  over_rows_ = std::abs(posts.y) >= std::abs(posts.x);
  from_last_ = (over_rows_ ? posts.y : posts.x) > 0;
  size_ = {layer.grid->columns, layer.grid->rows};
  if (!over_rows_) std::swap(size_.x, size_.y);
  regular_ = std::isfinite(posts.x) && std::isfinite(posts.y);
}

// From (x, line) to (u, v).
glm::dvec2 SunField::uv_of(glm::dvec2 xy) const {
  if (from_last_) xy.y = size_.y - 1 - xy.y;
  return over_rows_ ? xy : glm::dvec2(xy.y, xy.x);
}

glm::dvec2 SunField::xy_of(glm::dvec2 uv) const {
  glm::dvec2 xy = over_rows_ ? uv : glm::dvec2(uv.y, uv.x);
  if (from_last_) xy.y = size_.y - 1 - xy.y;
  return xy;
}

SunField::Way SunField::way(const Terrain& terrain, const glm::dvec3& at_m,
                            const glm::dvec3& direction) const {
  const GridDirection in = in_grid(terrain, at_m, direction);
  const double over = (over_rows_ ? in.posts.y : in.posts.x) * (from_last_ ? 1 : -1);
  const double along = over_rows_ ? in.posts.x : in.posts.y;
  const bool regular = over > 0 && in.rise > 0 &&
                       direction.z <= kSteepest * glm::length(glm::dvec2(direction)) &&
                       std::abs(along) <= kMostDrift * over;
  return {along / over, in.rise / over, regular};
}

// The field at a node, at the lowest and the highest ground; and how a ray from there, which is
// straight in the view frame, has turned from it where it ends.
SunRates SunField::sample(const Terrain& terrain, const glm::dvec3& to_sun, glm::dvec2 ground_m) {
  const VerticalFrame& frame = terrain.frame();
  std::optional<SunRates> rates;
  const glm::dvec2 range_m = terrain.height_range_m();
  for (const double height_m : {range_m.x, range_m.y}) {
    const glm::dvec3 at_m(ground_m, frame.at(ground_m).z_m(height_m));
    const glm::dvec3 direction = direction_at(frame, at_m, to_sun);
    const Way here = way(terrain, at_m, direction);
    regular_ &= here.regular;
    if (linear_) return {here.drift, 0, here.rise, here.rise};
    const glm::dvec3 end_m = at_m + length_m(terrain, at_m, direction) * direction;
    const Way ray = way(terrain, end_m, direction);
    const Way field = way(terrain, end_m, direction_at(frame, end_m, to_sun));
    regular_ &= ray.regular && field.regular;
    const double turn = 2 * std::abs(ray.drift - field.drift);
    const double lift = 2 * std::abs(ray.rise - field.rise);
    const SunRates rates_here{here.drift, turn, here.rise - lift, here.rise + lift};
    rates = rates ? rates->with(rates_here) : rates_here;
  }
  return *rates;
}

void SunField::fill_lattice(const Terrain& terrain, const glm::dvec3& to_sun) {
  lattice_.resize(static_cast<std::size_t>(nodes_ * nodes_));
  glm::dvec2 ground_m(0);
  for (int line = 0; regular_ && line < nodes_; ++line) {
    for (int x = 0; regular_ && x < nodes_; ++x) {
      const glm::dvec2 xy = glm::dvec2(x, line) * glm::dvec2(size_ - 1) / (nodes_ - 1.0);
      ground_m = ground_of(*terrain.layers()[0].map, uv_of(xy), ground_m);
      node(x, line) = sample(terrain, to_sun, ground_m);
    }
  }
}

// What a smooth function does between nodes that are one apart is, of a straight line between them,
// at most an eighth of its second difference along each side of the lattice; here twice that.
void SunField::widen_between_nodes() {
  double drift_bend = 0;
  double rise_bend = 0;
  double most_turn = 0;  // from node to node
  const auto see = [&](const SunRates& a, const SunRates& b, const SunRates& c) {
    for (const SunRates& beside : {a, c})
      most_turn = std::max(most_turn, std::abs(beside.drift - b.drift) + beside.spread + b.spread);
    drift_bend = std::max(drift_bend, std::abs(a.drift - 2 * b.drift + c.drift));
    for (double SunRates::*rise : {&SunRates::rise_least, &SunRates::rise_most})
      rise_bend = std::max(rise_bend, std::abs(a.*rise - 2 * (b.*rise) + c.*rise));
  };
  for (int i = 0; i < nodes_; ++i) {
    for (int j = 1; j + 1 < nodes_; ++j) {
      see(node(j - 1, i), node(j, i), node(j + 1, i));
      see(node(i, j - 1), node(i, j), node(i, j + 1));
    }
  }
  for (SunRates& rates : lattice_) {
    rates.spread += drift_bend / 2;
    rates.rise_least -= rise_bend / 2;
    rates.rise_most += rise_bend / 2;
    regular_ &= rates.rise_least > 0 && rates.spread <= kMostDrift;
  }
  const double posts_a_node = std::max(1, std::min(size_.x, size_.y) - 1) / (nodes_ - 1.0);
  if (!linear_) track_turn_ = kEyeTurn + kTurnOfBend * std::sqrt(most_turn / posts_a_node);
}

void SunField::blur_the_eye(const Terrain& terrain) {
  const VerticalFrame& frame = terrain.frame();
  if (frame.is_flat()) return;
  blur_ = 2 * std::abs(frame.bend(terrain.height_bound_m()).least_m) / frame.z_scale;
  const double rise = rates({0, 0}, glm::dvec2(size_)).rise_least;
  near_eye_ = 1 + 2 * blur_ / (kEyeTurn * rise);
  eye_xy_ = xy_of(terrain.layers()[0].map->to_grid({0, 0}));
}

SunRates SunField::rates(glm::dvec2 first_xy, glm::dvec2 last_xy) const {
  const glm::dvec2 per_post = (nodes_ - 1.0) / glm::dvec2(size_ - 1);
  const glm::ivec2 most(nodes_ - 1);
  const glm::ivec2 first = glm::clamp(glm::ivec2(glm::floor(first_xy * per_post)), {0, 0}, most);
  const glm::ivec2 last = glm::clamp(glm::ivec2(glm::ceil(last_xy * per_post)), {0, 0}, most);
  SunRates bound = node(first.x, first.y);
  for (int line = first.y; line <= last.y; ++line)
    for (int x = first.x; x <= last.x; ++x) bound = bound.with(node(x, line));
  return bound;
}

double SunField::track_error() const { return linear_ ? 0 : 2 * GroundMap::kTrackError_cells; }

}  // namespace terrview

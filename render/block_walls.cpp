#include "render/block_walls.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "terrain/grid_walk.h"

namespace terrview {
namespace {

// Of a post: points so near a corner belong to the walls on both sides of it.
constexpr double kAtCorner_posts = 1e-6;
// Of a post: what lies just outside a wall, or just inside.
constexpr double kBeside_posts = 1e-6;

bool has_ground(const HeightGrid& grid, glm::ivec2 cell) {
  return cell.x >= 0 && cell.y >= 0 && cell.x < grid.columns - 1 && cell.y < grid.rows - 1 &&
         grid.has_ground(cell.x, cell.y);
}

// The cell beside an edge: (line, place) are grid coordinates along `axis` and across it.
glm::ivec2 cell_beside(int axis, int line, int place) {
  return axis == 0 ? glm::ivec2(line, place) : glm::ivec2(place, line);
}

int lines_of(const HeightGrid& grid, int axis) { return axis == 0 ? grid.columns : grid.rows; }

std::vector<char> lines_with_walls(const HeightGrid& grid, int axis) {
  std::vector<char> lines(static_cast<std::size_t>(lines_of(grid, axis)), 0);
  for (int line = 0; line < lines_of(grid, axis); ++line) {
    char& any = lines[static_cast<std::size_t>(line)];
    for (int place = 0; place < lines_of(grid, 1 - axis) - 1 && any == 0; ++place)
      any = has_ground(grid, cell_beside(axis, line - 1, place)) !=
            has_ground(grid, cell_beside(axis, line, place));
  }
  return lines;
}

// The distances along `ray` at which its z lies between two.
std::pair<double, double> distances_between(const Ray& ray, double low_z_m, double high_z_m) {
  const double slope = ray.direction.z;
  if (slope == 0) {
    const bool within = ray.origin_m.z >= low_z_m && ray.origin_m.z <= high_z_m;
    return {0, within ? ray.length_m : -1};
  }
  const double to_low_m = (low_z_m - ray.origin_m.z) / slope;
  const double to_high_m = (high_z_m - ray.origin_m.z) / slope;
  return {std::max(0.0, std::min(to_low_m, to_high_m)),
          std::min(ray.length_m, std::max(to_low_m, to_high_m))};
}

}  // namespace

// Where a ray crosses a line of a grid.
class BlockWalls::Crossing {
 public:
  Crossing(const BlockWalls& block, const Walls& walls, int axis, int line, const Ray& ray,
           double distance_m, bool forward)
      : block_(block),
        grid_(*walls.grid),
        axis_(axis),
        line_(line),
        forward_(forward),
        position_m_(ray.origin_m + ray.direction * distance_m),
        place_((walls.origin_uv + walls.jacobian * glm::dvec2(position_m_))[1 - axis]) {
    const glm::dvec3 size = glm::abs(ray.origin_m) + glm::abs(position_m_);
    slack_m_ = kOver * (size.x + size.y + size.z + 1);
  }

  // How far the upper edge of the wall lies above the crossing; none: no wall is met there.
  [[nodiscard]] std::optional<double> below_top_m() const {
    const int last = lines_of(grid_, 1 - axis_) - 2;
    const int place = static_cast<int>(std::clamp<double>(std::floor(place_), 0, last));
    if (const auto below = below_top_m(place)) return below;
    const double along = place_ - place;
    if (along < kAtCorner_posts && place > 0) return below_top_m(place - 1);
    if (along > 1 - kAtCorner_posts && place < last) return below_top_m(place + 1);
    return std::nullopt;
  }

  [[nodiscard]] const glm::dvec3& position_m() const { return position_m_; }

 private:
  [[nodiscard]] std::optional<double> below_top_m(int place) const {
    const double along = place_ - place;
    if (along < -kAtCorner_posts || along > 1 + kAtCorner_posts) return std::nullopt;
    const int before = forward_ ? line_ - 1 : line_;
    const int behind = forward_ ? line_ : line_ - 1;
    if (has_ground(grid_, cell_beside(axis_, before, place)) ||
        !has_ground(grid_, cell_beside(axis_, behind, place)))
      return std::nullopt;
    const glm::ivec2 from = cell_beside(axis_, line_, place);
    const glm::ivec2 to = cell_beside(axis_, line_, place + 1);
    const double height_m = glm::mix(double{grid_.at(from.x, from.y)}, double{grid_.at(to.x, to.y)},
                                     std::clamp(along, 0.0, 1.0));
    const VerticalFrame& frame = block_.terrain_->frame();
    const double below_m = frame.z_scale * height_m - frame.eye_height_m - position_m_.z;
    const double over_plinth_m = position_m_.z - block_.plinth_z_m_;
    if (below_m < -slack_m_ || over_plinth_m < -slack_m_) return std::nullopt;
    return below_m;
  }

  const BlockWalls& block_;
  const HeightGrid& grid_;
  int axis_;
  int line_;
  bool forward_;
  glm::dvec3 position_m_;
  double place_;
  double slack_m_ = 0;
};

BlockWalls::BlockWalls(std::shared_ptr<const Terrain> terrain, double plinth_z_m, double line_m)
    : terrain_(std::move(terrain)),
      plinth_z_m_(plinth_z_m),
      top_z_m_(terrain_->ceiling_m()),
      line_m_(line_m) {
  assert(terrain_->frame().is_flat());
  for (const TerrainLayer& layer : terrain_->layers()) {
    assert(layer.map->linear());
    layers_.push_back({layer.grid.get(), layer.map->to_grid(glm::dvec2(0)), *layer.map->linear(),
                       lines_with_walls(*layer.grid, 0), lines_with_walls(*layer.grid, 1)});
  }
}

Box BlockWalls::bounds() const {
  const double over_m = 1 + 1e-6 * terrain_->reach_m();
  const glm::dvec2 reach_m(terrain_->reach_m() + over_m);
  return {{-reach_m, plinth_z_m_ - over_m}, {reach_m, top_z_m_ + over_m}};
}

bool BlockWalls::covered(std::size_t layer, const glm::dvec2& ground_m,
                         const glm::dvec2& outward_m) const {
  for (std::size_t i = 0; i < layers_.size(); ++i) {
    if (i == layer) continue;
    const Walls& other = layers_[i];
    const auto goes_on = [&](const glm::dvec2& at_m) {
      const glm::dvec2 uv = other.origin_uv + other.jacobian * at_m;
      return other.grid->covers(uv) && has_ground(*other.grid, cell_of(*other.grid, uv));
    };
    // Of walls on one line that of the preferred layer stands.
    if (goes_on(ground_m + outward_m) || (i < layer && goes_on(ground_m - outward_m))) return true;
  }
  return false;
}

std::optional<SurfaceHit> BlockWalls::first_crossing(std::size_t layer, int axis,
                                                     const Ray& ray) const {
  const Walls& walls = layers_[layer];
  const double start = (walls.origin_uv + walls.jacobian * glm::dvec2(ray.origin_m))[axis];
  const double pace = (walls.jacobian * glm::dvec2(ray.direction))[axis];
  const double over_m = 2 * kOver * (terrain_->reach_m() + glm::length(ray.origin_m) + 1);
  const auto [near_m, far_m] = distances_between(ray, plinth_z_m_ - over_m, top_z_m_ + over_m);
  if (pace == 0 || near_m > far_m) return std::nullopt;
  const std::vector<char>& stand = axis == 0 ? walls.across_u : walls.across_v;
  const double last = static_cast<double>(stand.size()) - 1;
  const bool forward = pace > 0;
  // A line that rounding puts before the start or behind the end is sorted out by its distance.
  const double first_at = start + pace * near_m + (forward ? -1 : 1);
  const double last_at = start + pace * far_m + (forward ? 1 : -1);
  const int from = static_cast<int>(std::clamp(std::round(first_at), 0.0, last));
  const int to = static_cast<int>(std::clamp(std::round(last_at), 0.0, last));
  const int step = forward ? 1 : -1;
  for (int line = from; line != to + step; line += step) {
    if (stand[static_cast<std::size_t>(line)] == 0) continue;
    const double distance_m = (line - start) / pace;
    if (!(distance_m >= 0 && distance_m <= ray.length_m)) continue;
    const Crossing crossing(*this, walls, axis, line, ray, distance_m, forward);
    const auto below_m = crossing.below_top_m();
    if (!below_m) continue;
    const glm::dvec2 posts_per_m(walls.jacobian[0][axis], walls.jacobian[1][axis]);
    const glm::dvec2 normal = glm::normalize(forward ? -posts_per_m : posts_per_m);
    const glm::dvec2 outward_m = normal * (kBeside_posts / glm::length(posts_per_m));
    if (covered(layer, glm::dvec2(crossing.position_m()), outward_m)) continue;
    const double over_plinth_m = crossing.position_m().z - plinth_z_m_;
    const Part part = std::min(*below_m, over_plinth_m) < line_m_ ? kLine : kFace;
    return SurfaceHit{distance_m, crossing.position_m(), {normal, 0}, part};
  }
  return std::nullopt;
}

std::optional<SurfaceHit> BlockWalls::first_hit(const Ray& ray) const {
  const Ray unit{ray.origin_m, glm::normalize(ray.direction), ray.length_m};
  std::optional<SurfaceHit> nearest;
  for (std::size_t layer = 0; layer < layers_.size(); ++layer) {
    for (const int axis : {0, 1}) {
      const auto hit = first_crossing(layer, axis, unit);
      if (hit && (!nearest || hit->distance_m < nearest->distance_m)) nearest = hit;
    }
  }
  return nearest;
}

}  // namespace terrview

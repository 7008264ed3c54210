#include "terrain/post_ground.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace terrview {
namespace {

constexpr glm::dvec2 kNowhere(std::numeric_limits<double>::quiet_NaN());

// The guess for a post is what its neighbour nearer to the eye's column says.
class RowSearch {
 public:
  RowSearch(const GroundMap& map, int row, std::vector<glm::dvec2>& nearest)
      : map_(map), row_(row), nearest_(nearest), eye_uv_(map.to_grid(glm::dvec2(0))) {}

  void run() {
    const int last = static_cast<int>(nearest_.size()) - 1;
    const int middle = static_cast<int>(std::clamp(std::round(eye_uv_.x), 0.0, 1.0 * last));
    glm::dvec2 guess_m = from_eye(middle);
    for (int column = middle; column <= last; ++column) guess_m = find(column, guess_m, 1);
    guess_m = from_eye(middle - 1);
    for (int column = middle - 1; column >= 0; --column) guess_m = find(column, guess_m, -1);
  }

 private:
  [[nodiscard]] glm::dvec2 from_eye(int column) const {
    return glm::inverse(map_.jacobian(glm::dvec2(0))) * (glm::dvec2(column, row_) - eye_uv_);
  }

  // Returns the guess for the next column.
  glm::dvec2 find(int column, glm::dvec2 guess_m, int step) {
    const auto found = ground_of(map_, {column, row_}, guess_m);
    if (!found) return from_eye(column + step);
    glm::dvec2& nearest = nearest_[static_cast<std::size_t>(column)];
    if (!(glm::length(nearest) <= glm::length(*found))) nearest = *found;
    return *found + static_cast<double>(step) * glm::inverse(map_.jacobian(*found))[0];
  }

  const GroundMap& map_;
  int row_;
  std::vector<glm::dvec2>& nearest_;
  glm::dvec2 eye_uv_;
};

}  // namespace

std::optional<glm::dvec2> ground_of(const GroundMap& map, glm::dvec2 uv, glm::dvec2 guess_m) {
  constexpr int kMostSteps = 32;
  glm::dvec2 ground_m = guess_m;
  for (int step = 0; step < kMostSteps; ++step) {
    const glm::dvec2 error = map.to_grid(ground_m) - uv;
    if (glm::length(error) <= kPostGround_cells)
      return glm::length(ground_m) <= map.reach_m() ? std::optional(ground_m) : std::nullopt;
    ground_m -= glm::inverse(map.jacobian(ground_m)) * error;
    if (!std::isfinite(ground_m.x + ground_m.y)) break;
  }
  return std::nullopt;
}

std::vector<glm::dvec2> ground_of_row(const Terrain& terrain, const HeightGrid& grid, int row) {
  std::vector<glm::dvec2> nearest(static_cast<std::size_t>(grid.columns), kNowhere);
  for (const TerrainLayer& layer : terrain.layers())
    if (layer.grid.get() == &grid) RowSearch(*layer.map, row, nearest).run();
  return nearest;
}

}  // namespace terrview

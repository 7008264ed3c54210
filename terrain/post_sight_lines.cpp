#include "terrain/post_sight_lines.h"

#include <cmath>
#include <cstddef>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "terrain/track_piece.h"

namespace terrview {
namespace {

// How far a line of sight goes on beyond the last line that it crosses: above rounding.
constexpr double kBeyond_cells = 1e-7;

glm::dvec2 on_track(const GroundMap& map, glm::dvec2 ground_m) {
  const double g_m = glm::length(ground_m);
  return g_m > 0 ? track_point(map, ground_m / g_m, g_m).uv : map.to_grid(ground_m);
}

// By Newton's method from a guess. Where the patches of a map meet it may go to and fro between
// two.
std::optional<glm::dvec2> find_place(const GroundMap& map, glm::dvec2 uv, glm::dvec2 ground_m) {
  constexpr int kSteps = 28;
  constexpr int kStepsOverSeams = 4;
  for (int step = 0; step < kSteps + kStepsOverSeams && std::isfinite(ground_m.x + ground_m.y);
       ++step) {
    const glm::dvec2 error = on_track(map, ground_m) - uv;
    const double allowed = step < kSteps ? kPostPlace_cells : GroundMap::kTrackError_cells;
    if (glm::length(error) <= allowed) return ground_m;
    ground_m -= glm::inverse(map.jacobian(ground_m)) * error;
  }
  return std::nullopt;
}

// A post's guess is its own: places do not depend on which others are asked for.
void add_places(const GroundMap& map, int row, std::span<const int> columns,
                std::span<PostPlace> nearest) {
  const glm::dvec2 eye_uv = map.to_grid(glm::dvec2(0));
  const glm::dmat2 at_eye = glm::inverse(map.jacobian(glm::dvec2(0)));
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const glm::dvec2 post(columns[i], row);
    const auto place_m = find_place(map, post, at_eye * (post - eye_uv));
    if (!place_m) continue;
    const double away_m = glm::length(*place_m);
    if (away_m <= map.reach_m() &&
        (nearest[i].map == nullptr || away_m < glm::length(nearest[i].ground_m)))
      nearest[i] = {*place_m, &map};
  }
}

// Just beyond where the line to `post`, `away_m` along it, last crosses a row or a column before.
double last_line_m(const GroundMap& map, glm::dvec2 direction, glm::dvec2 post, double away_m) {
  const glm::dvec2 rate = track_point(map, direction, away_m).rate;
  const int axis = std::abs(rate.x) >= std::abs(rate.y) ? 0 : 1;
  const double line = post[axis] - glm::sign(rate[axis]);
  const double near_m = away_m - 1 / std::abs(rate[axis]);
  if (near_m <= 0) return near_m;
  const TrackPoint near = track_point(map, direction, near_m);
  return near_m + (line - near.uv[axis]) / near.rate[axis] +
         kBeyond_cells / std::abs(near.rate[axis]);
}

}  // namespace

std::vector<PostPlace> places_in_row(const Terrain& terrain, const HeightGrid& grid, int row,
                                     std::span<const int> columns) {
  std::vector<PostPlace> nearest(columns.size());
  for (const TerrainLayer& layer : terrain.layers())
    if (layer.grid.get() == &grid) add_places(*layer.map, row, columns, nearest);
  return nearest;
}

std::optional<Ray> line_of_sight(const VerticalFrame& frame, const PostPlace& place,
                                 glm::ivec2 post, double scene_height_m) {
  const double away_m = glm::length(place.ground_m);
  if (away_m == 0) return std::nullopt;
  const double end_m = last_line_m(*place.map, place.ground_m / away_m, post, away_m);
  if (end_m <= 0) return std::nullopt;
  const glm::dvec3 observer_m(place.ground_m, frame.at(place.ground_m).z_m(scene_height_m));
  return Ray{{0, 0, 0}, observer_m, glm::length(observer_m) * (end_m / away_m)};
}

}  // namespace terrview

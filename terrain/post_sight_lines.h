// Lines of sight between the eye and observers above the posts of a grid.
//
// A line of sight is a ray from the eye. Its track over the grid, as all tracks from the eye are
// followed, leads through the post; and it ends where it last crosses a row or a column before the
// post. From there on the ground is a chord up to the post, on which the observer stands: it does
// not hide him, and rounding shall not make it.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "terrain/ground_map.h"
#include "terrain/ray.h"
#include "terrain/terrain.h"

namespace terrview {

// Where a post lies: on the track of the line from the eye to `ground_m` over `map`, there.
struct PostPlace {
  glm::dvec2 ground_m{0, 0};
  const GroundMap* map = nullptr;  // null = nowhere within reach of the eye
};

// Of these columns of a row of `grid`, a layer of `terrain`, each the same whichever others are
// asked for: to kPostPlace_cells, or where patches of a map meet to GroundMap::kTrackError_cells.
// Where two layers are of one grid, a turn of the Earth apart, the place nearer to the eye.
inline constexpr double kPostPlace_cells = 1e-7;
[[nodiscard]] std::vector<PostPlace> places_in_row(const Terrain& terrain, const HeightGrid& grid,
                                                   int row, std::span<const int> columns);

// The line of sight to an observer whose eye is at a scene height above `post`; nullopt where
// no row or column lies between.
[[nodiscard]] std::optional<Ray> line_of_sight(const VerticalFrame& frame, const PostPlace& place,
                                               glm::ivec2 post, double scene_height_m);

}  // namespace terrview

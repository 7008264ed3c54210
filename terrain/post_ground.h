// Where the posts of a grid lie on the ground of the view frame: the inverse of a GroundMap.
#pragma once

#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include "terrain/ground_map.h"
#include "terrain/terrain.h"

namespace terrview {

// How near to a post the ground found for it lies.
inline constexpr double kPostGround_cells = 1e-7;

// The ground point of grid coordinates, by Newton's method from `guess_m`; nullopt where that does
// not lead to one within reach of the eye.
[[nodiscard]] std::optional<glm::dvec2> ground_of(const GroundMap& map, glm::dvec2 uv,
                                                  glm::dvec2 guess_m);

// That of every post of a row of `grid`, a layer of `terrain`; NaN where there is none. Where two
// layers are of one grid, a turn of the Earth apart, the nearer to the eye.
[[nodiscard]] std::vector<glm::dvec2> ground_of_row(const Terrain& terrain, const HeightGrid& grid,
                                                    int row);

}  // namespace terrview

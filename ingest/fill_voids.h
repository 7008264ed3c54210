// Small holes in a grid, closed.
#pragma once

#include <cstddef>

#include "terrain/height_grid.h"

namespace terrview {

// Fills every void (posts without a height that touch each other, corners included) that does not
// touch the border of `grid` and is at most `widest_posts` long along rows and columns, by
// GDALFillNodata (inverse distance to the nearest heights). Returns the number of posts filled.
// Heights that were there do not change; the order of filling changes nothing.
std::size_t fill_voids(HeightGrid& grid, int widest_posts);

}  // namespace terrview

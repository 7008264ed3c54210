// Small holes in a grid, closed.
#pragma once

#include <cstddef>

#include "terrain/height_grid.h"

namespace terrview {

// How far from an empty post heights are looked for.
inline constexpr int kFillReach_posts = 46;

// Fills every void (posts without a height that touch each other, corners included) that does not
// touch the border of `grid` and is at most `widest_posts` long along rows and columns, by
// GDALFillNodata: the mean of the nearest height in each quadrant, weighted by inverse distance, as
// `gdal_fillnodata.py -md 46` fills the whole grid. Returns the number of posts filled. Heights
// that were there do not change, and filled ones take no part.
std::size_t fill_voids(HeightGrid& grid, int widest_posts);

}  // namespace terrview

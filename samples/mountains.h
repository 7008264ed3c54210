// The project's own sample landscape: an invented massif with a valley, in the manner of the
// Vosges.
#pragma once

#include "terrain/height_grid.h"

namespace terrview {

// Where the sample lies: geographic, WGS 84, its middle post on 48 N 7 E, about 60 m x 90 m a cell.
inline constexpr int kSampleSize_posts = 257;
inline constexpr double kSampleLongitudeStep_deg = 0.000805;
inline constexpr double kSampleLatitudeStep_deg = 0.00081;
inline constexpr double kSampleMiddleLongitude_deg = 7;
inline constexpr double kSampleMiddleLatitude_deg = 48;

// Heights in whole metres, row 0 in the north: the same on every machine.
//
// Method: midpoint subdivision of a hand-drawn 9 x 9 relief. The midpoints are those of the 4-point
// scheme (Dyn, Levin & Gregory, CAGD 4, 1987), which leaves no crease along the coarse lines; each
// level then displaces every post (successive random additions: Voss, in The Science of Fractal
// Images, 1988), the more the higher it lies, and from the third on rivers cut their valleys.
[[nodiscard]] HeightGrid make_mountains();

}  // namespace terrview

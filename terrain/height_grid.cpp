#include "terrain/height_grid.h"

#include <cmath>
#include <limits>

namespace terrview {

HeightRange height_range(const HeightGrid& grid) {
  HeightRange range{std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity(),
                    false};
  for (const float height_m : grid.heights_m) {
    range.has_holes |= std::isnan(height_m);
    // Comparisons with NaN are false, so posts without data never count.
    if (height_m < range.lowest_m) range.lowest_m = height_m;
    if (height_m > range.highest_m) range.highest_m = height_m;
  }
  if (range.lowest_m > range.highest_m) {
    constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
    return {kNone, kNone, range.has_holes};
  }
  return range;
}

}  // namespace terrview

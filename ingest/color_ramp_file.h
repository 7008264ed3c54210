// Colours by altitude from files (--colors).
//
// Two formats. gdaldem color-relief text: a line is a height (or a percentage of the DEM's range),
// then red, green, blue from 0 to 255 or a colour's name, parted by blanks, commas or colons;
// alpha, `nv` lines and comments after # are passed over; colours are interpolated. And QGIS's
// colour map export: `INTERPOLATION:INTERPOLATED|DISCRETE|EXACT`, then
// `value,red,green,blue,alpha,label`.
#pragma once

#include <string>
#include <string_view>

#include "render/color_ramp.h"
#include "terrain/height_grid.h"

namespace terrview {

// `range` is what percentages are of. Throws InputError, with the number of the line.
[[nodiscard]] ColorRamp read_color_ramp(const std::string& path, HeightRange range);

// The same of a file's text; `name` is for errors.
[[nodiscard]] ColorRamp parse_color_ramp(std::string_view text, const std::string& name,
                                         HeightRange range);

}  // namespace terrview

// How far ground can matter to a view.
#pragma once

#include "terrain/vertical_frame.h"

namespace terrview {

// No ground between these heights (of the scene, z_scale included), further than this from the eye,
// can be seen from it, or throw a shadow on what is seen: it lies below the horizon. A bound from
// above, within 80 degrees of arc; infinite on a flat Earth.
[[nodiscard]] double sight_m(const VerticalFrame& frame, double lowest_m, double highest_m);

}  // namespace terrview

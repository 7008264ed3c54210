// The colours of light and sky by the height of the sun, for a clear day seen by an adapted eye.
#pragma once

#include "render/scene.h"

namespace terrview {

struct Daylight {
  glm::vec3 sun;      // as Light's
  glm::vec3 ambient;  // as Light's
  SkyGradient sky;
};

// Continuous in `elevation_rad`, and never brighter for a lower sun. The sun reddens with the air
// its light crosses (F. Kasten & A. T. Young, Applied Optics 28(22), 1989) and is gone at -3
// degrees, for it still reaches high ground when it has set at the eye; the sky darkens through
// civil (-6 degrees), nautical (-12) and astronomical (-18) dusk, and no further.
[[nodiscard]] Daylight daylight(double elevation_rad);

}  // namespace terrview

// The map of a study: viewpoints and the project over the relief, and from where it can be seen.
#pragma once

#include <string>

#include "cli/impact/impact_table.h"
#include "ingest/zone.h"

namespace terrview {

// The zone of the project's roofs, which buildings that stand already may hide. Throws InputError,
// Interrupted.
[[nodiscard]] Zone zone_of(const StudyGround& ground);

// An SVG element with everything in it, for HTML. The first DEM's part that holds all viewpoints
// and the project, its rows level; pixels are square where it has its middle. `zone` may be null.
[[nodiscard]] std::string map_svg(const ImpactStudy& study, const StudyGround& ground,
                                  const Zone* zone);

}  // namespace terrview

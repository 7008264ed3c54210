// The polygons of a feature.
#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "ingest/vector_file.h"
#include "render/objects/polygon.h"

namespace terrview {

// Those of its geometry, of whatever collection and curve, in the coordinates of the file, x to the
// east; of each the outline first. Throws InputError for a corner that is nowhere.
[[nodiscard]] std::vector<std::vector<Polygon::Ring>> polygons_of(const VectorFeature& feature);

// (x, y), if that is somewhere. Throws InputError.
[[nodiscard]] glm::dvec2 checked_corner(const VectorFeature& feature, double x, double y);

}  // namespace terrview

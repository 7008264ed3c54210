// From the coordinates of a vector file to the ground of a view frame.
#pragma once

#include <span>

#include <glm/vec2.hpp>

#include "ingest/vector_file.h"
#include "ingest/view_frame.h"

namespace terrview {

// In place. A point that is nowhere on the Earth becomes NaN. Throws InputError if the file's
// coordinate reference system is of no use.
void to_ground(const VectorFile& file, const ViewFrame& frame, std::span<glm::dvec2> points);

}  // namespace terrview

// From the coordinates of a vector file to the ground of a view frame.
#pragma once

#include <span>

#include <glm/vec2.hpp>

#include "ingest/vector_file.h"
#include "ingest/view_frame.h"

namespace terrview {

// In place, from the coordinate reference system of a file, which it has, to (longitude, latitude)
// in degrees of WGS 84. A point that is nowhere on the Earth becomes NaN. Throws InputError if the
// system is of no use.
void to_geographic(const VectorFile& file, std::span<glm::dvec2> points);

// The same to the ground of a frame. Without a system of the file or of the DEMs the points are in
// the first DEM's own coordinates.
void to_ground(const VectorFile& file, const ViewFrame& frame, std::span<glm::dvec2> points);

}  // namespace terrview

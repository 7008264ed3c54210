// The maps of objects beside a uniform grid and Embree on cities of random boxes.
#pragma once

#include <ostream>

#include "bench/objects/object_scene.h"

namespace terrview {

// Medians of five turns. Tables of Markdown: time and memory of building, then speed beside error
// for each view, one thread.
void write_city_tables(const City& city, std::ostream& out);

}  // namespace terrview

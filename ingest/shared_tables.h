#pragma once

#include <vector>

#include "ingest/dem.h"

namespace terrview {

// Makes the tables that are missing of the DEMs' grids and that views of them have in common: 8 / 3
// bytes a post.
void make_shared_tables(std::vector<Dem>& dems, int threads);

}  // namespace terrview

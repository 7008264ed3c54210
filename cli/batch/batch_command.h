#pragma once

#include <string>
#include <vector>

namespace terrview {

// `terrview batch JOBS --dem DEM... -o TEMPLATE`: many pictures from a table. Returns the exit
// code; throws InputError before the first of them.
int run_batch(const std::vector<std::string>& args);

}  // namespace terrview

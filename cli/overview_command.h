#pragma once

#include <string>
#include <vector>

namespace terrview {

// `terrview overview DEM...`: the whole region as a block, a map or sheets of one. Returns the exit
// code; throws InputError.
int run_overview(const std::vector<std::string>& args);

}  // namespace terrview

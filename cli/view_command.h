#pragma once

#include <string>
#include <vector>

namespace terrview {

// `terrview [view] DEM... --eye ...`: one picture. Returns the exit code; throws InputError.
int run_view(const std::vector<std::string>& args);

}  // namespace terrview

#pragma once

#include <string>
#include <vector>

namespace terrview {

// terrview sky: a random field as a sky, flat or in perspective; or as wood or marble. Returns the
// exit code.
int run_sky(const std::vector<std::string>& args);

}  // namespace terrview

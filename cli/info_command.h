// terrview info: what one needs to know of DEMs before choosing an eye.
#pragma once

#include <string>
#include <vector>

namespace terrview {

// Returns the exit code. Throws InputError.
int run_info(const std::vector<std::string>& args);

}  // namespace terrview

// terrview quantize: any picture to a picture with a palette.
#pragma once

#include <string>
#include <vector>

namespace terrview {

// Returns the exit code. Throws InputError.
int run_quantize(const std::vector<std::string>& args);

}  // namespace terrview

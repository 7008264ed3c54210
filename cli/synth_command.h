#pragma once

#include <string>
#include <vector>

namespace terrview {

// terrview synth: a random field as a height grid. Returns the exit code.
int run_synth(const std::vector<std::string>& args);

}  // namespace terrview

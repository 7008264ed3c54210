#pragma once

#include <string>
#include <vector>

namespace terrview {

// Runs terrview-bench with `args`, without the program's name. Returns the exit code.
int run_bench(const std::vector<std::string>& args);

}  // namespace terrview

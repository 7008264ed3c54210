#pragma once

#include <string>
#include <vector>

namespace terrview {

// Runs one command line, without the program's name. Returns the exit code: 0 done, 1 failed,
// 2 usage or bad input, 130 interrupted.
int run(const std::vector<std::string>& args);

}  // namespace terrview

#pragma once

#include <string>
#include <vector>

namespace terrview {

// `terrview impact DEM... --buildings F --viewpoints F -o DIR`: what a project changes. Returns the
// exit code; throws InputError before the first picture.
int run_impact(const std::vector<std::string>& args);

}  // namespace terrview

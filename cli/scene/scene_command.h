#pragma once

#include <string>
#include <vector>

namespace terrview {

// Whether `name` is that of a scene file: *.json or *.xml, in letters of either case.
[[nodiscard]] bool is_scene_name(const std::string& name);

// `terrview SCENE.json [options]`: what the first of `args` describes. Returns the exit code;
// throws InputError.
int run_scene(const std::vector<std::string>& args);

}  // namespace terrview

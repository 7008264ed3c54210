// A view as a scene file: docs/scenes.md, docs/scene.schema.json.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "cli/batch/option_values.h"
#include "cli/scene/scene_file.h"

namespace terrview {

// The scene file of `terrview view DEM...` with options of these values; how the program behaves
// (-o, --threads, --quiet ...) is left out. Names of files, which are relative to the current
// folder, become relative to `folder`, where the scene file is to lie; empty = the current one.
[[nodiscard]] nlohmann::ordered_json scene_json(const OptionValues& values,
                                                const std::vector<std::string>& dems,
                                                const std::string& folder = "");

// The same of a scene file, with its own members; from anywhere, for the current folder.
[[nodiscard]] nlohmann::ordered_json scene_json(const SceneFile& scene);

// As a file holds it. Throws InputError where names of files are no UTF-8.
[[nodiscard]] std::string scene_text(const nlohmann::ordered_json& scene);

}  // namespace terrview

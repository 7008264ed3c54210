// The options of a view in a scene file.
#pragma once

#include "cli/batch/option_values.h"
#include "cli/scene/scene_node.h"

namespace terrview {

// The members of `options` are options of `terrview view` by their long names, without the dashes:
// true or false for a flag; a text, a number, or an array of these. Each is checked by itself.
// Throws InputError, as for an option of how the program behaves: those belong to whoever runs it.
[[nodiscard]] OptionValues read_scene_options(const SceneNode& options);

}  // namespace terrview

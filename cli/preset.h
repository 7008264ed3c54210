// Pictures of a fixed field of view and size on paper, for visual impact work.
#pragma once

#include "cli/view_options.h"

namespace terrview {

// --preset and --dpi.
void add_preset_options(CommandLine& app, ViewOptions& options);

// Fills in the projection, the field of view and the size of the preset that `options` names, if
// any. Throws InputError for a dpi that is none, and where these are given too.
void apply_preset(ViewOptions& options);

}  // namespace terrview

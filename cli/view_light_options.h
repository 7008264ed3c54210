#pragma once

#include "cli/view_options.h"

namespace terrview {

// The options of light and colours.
void add_light_options(CLI::App& app, ViewOptions& options);

}  // namespace terrview

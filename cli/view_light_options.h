#pragma once

#include "cli/view_options.h"

namespace terrview {

// The options of light, colours and air.
void add_light_options(CLI::App& app, ViewOptions& options);

// The options that say how many rays are traced, and in which order.
void add_sampling_options(CLI::App& app, ViewOptions& options);

}  // namespace terrview

#pragma once

#include "cli/view_options.h"

namespace terrview {

void add_light_options(CommandLine& app, ViewOptions& options);
void add_air_options(CommandLine& app, AirOptions& air);

// The options that say how many rays are traced, and in which order.
void add_sampling_options(CommandLine& app, ViewOptions& options);

}  // namespace terrview

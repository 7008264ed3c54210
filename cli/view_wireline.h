// A view as lines, in a file.
#pragma once

#include <string>

#include "cli/view_options.h"
#include "render/lines/wireline.h"

namespace terrview {

void add_wireline_options(CommandLine& app, WirelineOptions& options);

// Throws InputError for options that need others.
void check_wireline(const WirelineOptions& options);

// --wireline: docs/cli.md.
[[nodiscard]] std::string wireline_svg(const Wireline& wireline, glm::ivec2 size_px,
                                       const std::string& metadata);

}  // namespace terrview

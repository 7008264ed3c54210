#pragma once

#include <string>
#include <vector>

#include "cli/view_options.h"

namespace terrview {

// Checks what can be checked before any file is read, and fills in --from-camera. Throws
// InputError.
void prepare(ViewOptions& options);

// Throws InputError for a --z-scale that no view has.
void check_z_scale(const ViewOptions& options);

// The options that `args` say to `program`, prepared. Throws what CommandLine and prepare() throw.
[[nodiscard]] ViewOptions parse_view(const std::vector<std::string>& args,
                                     const std::string& program);

}  // namespace terrview

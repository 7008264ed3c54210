#pragma once

#include "cli/view_options.h"

namespace terrview {

// Checks what can be checked before any file is read, and fills in --from-camera. Throws
// InputError.
void prepare(ViewOptions& options);

}  // namespace terrview

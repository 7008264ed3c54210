#pragma once

#include <vector>

#include "cli/view_setup.h"

namespace terrview {

// Says on standard error what each DEM is, and its warnings.
void say_what_was_read(const std::vector<Dem>& dems);

// The same, and where the eye and the sun are.
void say_what_is_seen(const std::vector<Dem>& dems, const View& view);

}  // namespace terrview

// Numbers and places as the command line takes them.
#pragma once

#include <string>

#include "cli/impact/project.h"

namespace terrview {

// The shortest text that reads back as the same number.
[[nodiscard]] std::string exact_text(double value);

// LAT,LON, or X,Y.
[[nodiscard]] std::string place_text(PlanPlace place, bool geographic);

}  // namespace terrview

// Colours by absolute altitude that have a name.
#pragma once

#include <string_view>
#include <vector>

#include "render/color_ramp.h"

namespace terrview {

struct NamedRamp {
  std::string_view name;
  ColorRamp ramp;
};

// alpine, arid, polar and grey.
[[nodiscard]] const std::vector<NamedRamp>& named_ramps();

// Null if there is none of that name.
[[nodiscard]] const ColorRamp* find_named_ramp(std::string_view name);

}  // namespace terrview

// Sizes that a user may get wrong.
#pragma once

#include <cmath>
#include <sstream>
#include <string>

#include "terrain/error.h"

namespace terrview {

// Throws InputError unless the size is a finite number above 0, or 0 where that is allowed.
inline void check_size(const std::string& solid, const std::string& size, double value,
                       bool may_be_zero = false) {
  if (std::isfinite(value) && (value > 0 || (may_be_zero && value == 0))) return;
  std::ostringstream text;
  text << solid << ": " << size << ' ' << value << ": give a number "
       << (may_be_zero ? "of at least 0" : "above 0");
  throw InputError(text.str());
}

}  // namespace terrview

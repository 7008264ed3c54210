#pragma once

#include <string>

namespace terrview {

// The shortest text that reads back as the same number.
[[nodiscard]] std::string exact_text(double value);

}  // namespace terrview

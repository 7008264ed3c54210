// Texts of any length in messages of one line.
#pragma once

#include <cstddef>
#include <string>

namespace terrview {

// Its beginning, with `...` where there is more.
[[nodiscard]] inline std::string shortened(const std::string& text) {
  constexpr std::size_t kMost = 200;  // bytes
  return text.substr(0, kMost) + (text.size() > kMost ? "..." : "");
}

}  // namespace terrview

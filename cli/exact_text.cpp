#include "cli/exact_text.h"

#include <array>
#include <charconv>

namespace terrview {

std::string exact_text(double value) {
  std::array<char, 32> buffer{};
  return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr};
}

}  // namespace terrview

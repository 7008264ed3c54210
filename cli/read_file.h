#pragma once

#include <string>

namespace terrview {

// The bytes of a file. Throws InputError if it cannot be read to its end.
[[nodiscard]] std::string read_file(const std::string& path);

}  // namespace terrview

#pragma once

#include <string>

namespace terrview {

// Says on standard error what is wrong, as one line: names of files and rows may have line breaks.
void say_error(const std::string& what);

}  // namespace terrview

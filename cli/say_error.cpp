#include "cli/say_error.h"

#include <algorithm>
#include <cstdio>

namespace terrview {

void say_error(const std::string& what) {
  std::string line = what;
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; };
  std::replace_if(line.begin(), line.end(), is_control, ' ');
  std::fprintf(stderr, "terrview: %s\n", line.c_str());
}

}  // namespace terrview

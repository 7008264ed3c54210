// Ctrl-C, as an exception at the next progress report.
#pragma once

#include <string>

namespace terrview {

struct Interrupted {
  std::string left = {};  // the file that was written all the same
};

// From now on SIGINT, SIGTERM and SIGHUP are remembered instead of ending the program, and nobody
// reading its messages (`| head`) costs no picture.
void catch_interrupts();

// Throws Interrupted if one has come.
void check_interrupt();

}  // namespace terrview

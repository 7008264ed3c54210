// The options of `terrview impact`: docs/cli.md, one field each.
#pragma once

#include <string>
#include <vector>

#include "cli/batch/option_values.h"
#include "cli/view_options.h"

namespace terrview {

struct ImpactOptions {
  ViewOptions view;                   // of the command line alone; its buildings are the project
  OptionValues values;                // the same as texts
  std::vector<std::string> existing;  // buildings that stand already
  std::string viewpoints;
  std::string folder;
  std::string title;
  double eye_height_m = 1.6;
  bool zone = true;
  std::string command;  // as a shell takes it

  // Of the pictures without the project and with it: the options that all viewpoints share.
  [[nodiscard]] OptionValues values_before() const;
  [[nodiscard]] OptionValues values_after() const;
};

// Throws what CommandLine throws, and InputError.
[[nodiscard]] ImpactOptions parse_impact(const std::vector<std::string>& args);

// A command line that a shell takes, of the program's arguments.
[[nodiscard]] std::string shell_command(const std::vector<std::string>& args);

}  // namespace terrview

// One command's arguments, with the program's manners.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace terrview {

inline constexpr const char* kVersion = TERRVIEW_VERSION;

// Thrown after --help or --version has been printed.
struct NothingToDo {};

class CommandLine : public CLI::App {
 public:
  CommandLine(const std::string& description, const std::string& name);

  // Throws InputError with one line for a usage error, and NothingToDo after help.
  void parse_args(const std::vector<std::string>& args);
};

}  // namespace terrview

#include "cli/command_line.h"

#include <cstdio>

#include "terrain/error.h"

namespace terrview {

CommandLine::CommandLine(const std::string& description, const std::string& name)
    : CLI::App(description, name) {
  set_version_flag("--version", std::string("terrview ") + kVersion);
  // Numbers below zero look like options to the parser only where an option may come.
  allow_extras(false);
}

void CommandLine::parse_args(const std::vector<std::string>& args) {
  try {
    parse(std::vector<std::string>(args.rbegin(), args.rend()));
  } catch (const CLI::CallForHelp&) {
    std::printf("%s", help().c_str());
    throw NothingToDo{};
  } catch (const CLI::CallForVersion&) {
    std::printf("terrview %s\n", kVersion);
    throw NothingToDo{};
  } catch (const CLI::ParseError& error) {
    std::string line = error.what();
    for (char& c : line) {
      if (c == '\n') c = ' ';
    }
    throw InputError(line + ": see " + get_name() + " --help");
  }
}

}  // namespace terrview

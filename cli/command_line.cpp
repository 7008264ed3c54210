#include "cli/command_line.h"

#include <cstdio>

#include "terrain/error.h"

namespace terrview {
namespace {

// What the parser says, and how to mend it.
std::string explain(const CLI::ParseError& error, const CLI::App& app) {
  const std::string said = error.what();
  if (dynamic_cast<const CLI::ExtrasError*>(&error))
    return "'" + app.remaining().front() + "': no such option: " + app.get_name() +
           " --help lists them";
  if (dynamic_cast<const CLI::RequiredError*>(&error))
    return said + ": name a file; " + app.get_name() + " --help shows how";
  if (dynamic_cast<const CLI::ExcludesError*>(&error)) return said + ": leave one of them out";
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error))
    return said + ": give what the option needs after it";
  if (dynamic_cast<const CLI::ValidationError*>(&error)) return said + ": give a value from there";
  if (dynamic_cast<const CLI::ConversionError*>(&error)) return said + ": give a number";
  return said + ": see " + app.get_name() + " --help";
}

}  // namespace

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
    throw InputError(explain(error, *this));
  }
}

}  // namespace terrview

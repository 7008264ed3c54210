// One command's arguments, with the program's manners.
//
// What the commands know of CLI11: its header costs every source that includes it seconds to
// compile.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace terrview {

inline constexpr const char* kVersion = TERRVIEW_VERSION;

// Thrown after --help or --version has been printed.
struct NothingToDo {};

// What else is to be said of an option. Each call returns the option itself.
class CommandOption {
 public:
  explicit CommandOption(CLI::Option& option) : option_(option) {}

  // What --help says of it, if not what it was added with.
  CommandOption* description(const std::string& help);
  // What --help calls its value.
  CommandOption* type_name(const std::string& name);
  CommandOption* required(bool is_required = true);
  // The range of its value, both included.
  CommandOption* between(int low, int high);
  CommandOption* between(double low, double high);
  CommandOption* one_of(const std::vector<std::string>& words);
  template <class Value>
  CommandOption* one_of(const std::map<std::string, Value>& choices) {
    std::vector<std::string> words;
    for (const auto& [word, unused] : choices) words.push_back(word);
    return one_of(words);
  }
  CommandOption* needs(const CommandOption* other);
  CommandOption* excludes(const CommandOption* other);
  // How many values follow it.
  CommandOption* expected(int count);
  // Whether further values may follow without the option before each.
  CommandOption* allow_extra_args(bool allowed);
  // All values count where it is given several times, not only one.
  CommandOption* take_all();
  // Between values in one argument.
  CommandOption* delimiter(char separator);

 private:
  friend class CommandLine;

  CLI::Option& option_;
};

// An option as it was added, and its values on the command line.
struct OptionDefinition {
  std::string name;       // the long one (o for -o), without dashes
  std::string type_name;  // with what its value is checked for
  std::string help;
  bool is_flag = false;  // takes no value
  bool takes_all = false;
  std::vector<std::string> excludes;  // names
  std::vector<std::string> values;    // once parsed; a flag's is true
};

class CommandLine {
 public:
  CommandLine(const std::string& description, const std::string& name);
  ~CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  // An option, or a positional argument where `name` has no dashes. Of the kinds of Value that
  // command_line.cpp lists; the options live as long as this.
  template <class Value>
  CommandOption* add_option(const std::string& name, Value& value, const std::string& help);
  template <class Value>
  CommandOption* add_option_function(const std::string& name,
                                     const std::function<void(const Value&)>& take,
                                     const std::string& help);
  CommandOption* add_flag(const std::string& name, bool& value, const std::string& help);

  // One that is there.
  CommandOption* get_option(const std::string& name);
  void remove_option(const CommandOption* option);

  // Throws InputError with one line for a usage error, and NothingToDo after help.
  void parse_args(const std::vector<std::string>& args);

  // How often an option was given.
  [[nodiscard]] std::size_t count(const std::string& name) const;

  // Of every option but --version, in the order of --help; not of positional arguments.
  [[nodiscard]] std::vector<OptionDefinition> definitions() const;

 private:
  CommandOption* known(CLI::Option* option);

  std::unique_ptr<CLI::App> parser_;
  std::vector<std::unique_ptr<CommandOption>> options_;
};

}  // namespace terrview

// Kinds of options that the commands share.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "cli/command_line.h"
#include "cli/parse.h"

namespace terrview {

// An option whose text goes through one of the functions of cli/parse.h.
inline CommandOption* add_parsed(CommandLine& app, const std::string& name,
                                 std::function<void(const std::string&)> parse,
                                 const std::string& help) {
  return app.add_option_function<std::string>(name, std::move(parse), help);
}

// CLI11's own numbers may be nan, infinite or hexadecimal.
inline CommandOption* add_number(CommandLine& app, const std::string& name,
                                 std::optional<double>& value, const std::string& help) {
  return add_parsed(
             app, name,
             [&value, name](const std::string& text) { value = parse_number(name, text); }, help)
      ->type_name("NUMBER");
}

template <class Value>
CommandOption* add_choice(CommandLine& app, const std::string& name, Value& value,
                          const std::map<std::string, Value>& choices, const std::string& help) {
  std::string names;
  for (const auto& [key, unused] : choices) names += (names.empty() ? "" : "|") + key;
  return app
      .add_option_function<std::string>(
          name, [&value, choices](const std::string& text) { value = choices.at(text); }, help)
      ->one_of(choices)
      ->type_name(names);
}

// on or off.
inline CommandOption* add_switch(CommandLine& app, const std::string& name, bool& value,
                                 const std::string& help) {
  return app
      .add_option_function<std::string>(
          name, [&value](const std::string& text) { value = text == "on"; }, help)
      ->one_of({"on", "off"})
      ->type_name("on|off");
}

}  // namespace terrview

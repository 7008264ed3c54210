#include "cli/command_line.h"

#include <cstdio>
#include <optional>

#include <CLI/CLI.hpp>

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

std::string name_of(const CLI::Option& option) {
  return option.get_lnames().empty() ? option.get_snames().front() : option.get_lnames().front();
}

OptionDefinition definition_of(const CLI::Option& option) {
  OptionDefinition definition{
      .name = name_of(option),
      .type_name = option.get_type_name(),
      .help = option.get_description(),
      .is_flag = option.get_items_expected_max() == 0,
      .takes_all = option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll,
      .excludes = {},
      .values = option.count() > 0 ? option.results() : std::vector<std::string>()};
  for (const CLI::Option* other : option.get_excludes())
    definition.excludes.push_back(name_of(*other));
  return definition;
}

}  // namespace

CommandOption* CommandOption::description(const std::string& help) {
  option_.description(help);
  return this;
}

CommandOption* CommandOption::type_name(const std::string& name) {
  option_.type_name(name);
  return this;
}

CommandOption* CommandOption::required(bool is_required) {
  option_.required(is_required);
  return this;
}

CommandOption* CommandOption::between(int low, int high) {
  option_.check(CLI::Range(low, high));
  return this;
}

CommandOption* CommandOption::between(double low, double high) {
  option_.check(CLI::Range(low, high));
  return this;
}

CommandOption* CommandOption::one_of(const std::vector<std::string>& words) {
  option_.check(CLI::IsMember(words));
  return this;
}

CommandOption* CommandOption::needs(const CommandOption* other) {
  option_.needs(&other->option_);
  return this;
}

CommandOption* CommandOption::excludes(const CommandOption* other) {
  option_.excludes(&other->option_);
  return this;
}

CommandOption* CommandOption::expected(int count) {
  option_.expected(count);
  return this;
}

CommandOption* CommandOption::allow_extra_args(bool allowed) {
  option_.allow_extra_args(allowed);
  return this;
}

CommandOption* CommandOption::take_all() {
  option_.take_all();
  return this;
}

CommandOption* CommandOption::delimiter(char separator) {
  option_.delimiter(separator);
  return this;
}

CommandLine::CommandLine(const std::string& description, const std::string& name)
    : parser_(std::make_unique<CLI::App>(description, name)) {
  parser_->set_version_flag("--version", std::string("terrview ") + kVersion);
  // Numbers below zero look like options to the parser only where an option may come.
  parser_->allow_extras(false);
}

CommandLine::~CommandLine() = default;

template <class Value>
CommandOption* CommandLine::add_option(const std::string& name, Value& value,
                                       const std::string& help) {
  return known(parser_->add_option(name, value, help));
}

template CommandOption* CommandLine::add_option(const std::string&, std::string&,
                                                const std::string&);
template CommandOption* CommandLine::add_option(const std::string&, std::vector<std::string>&,
                                                const std::string&);
template CommandOption* CommandLine::add_option(const std::string&, int&, const std::string&);
template CommandOption* CommandLine::add_option(const std::string&, std::vector<int>&,
                                                const std::string&);
template CommandOption* CommandLine::add_option(const std::string&, double&, const std::string&);
template CommandOption* CommandLine::add_option(const std::string&, std::optional<double>&,
                                                const std::string&);
template CommandOption* CommandLine::add_option(const std::string&, std::optional<int>&,
                                                const std::string&);
template CommandOption* CommandLine::add_option(const std::string&, std::optional<std::string>&,
                                                const std::string&);

template <class Value>
CommandOption* CommandLine::add_option_function(const std::string& name,
                                                const std::function<void(const Value&)>& take,
                                                const std::string& help) {
  return known(parser_->add_option_function<Value>(name, take, help));
}

template CommandOption* CommandLine::add_option_function(
    const std::string&, const std::function<void(const std::string&)>&, const std::string&);
template CommandOption* CommandLine::add_option_function(const std::string&,
                                                         const std::function<void(const double&)>&,
                                                         const std::string&);
template CommandOption* CommandLine::add_option_function(
    const std::string&, const std::function<void(const std::vector<std::string>&)>&,
    const std::string&);

CommandOption* CommandLine::add_flag(const std::string& name, bool& value,
                                     const std::string& help) {
  return known(parser_->add_flag(name, value, help));
}

CommandOption* CommandLine::get_option(const std::string& name) {
  return known(parser_->get_option(name));
}

void CommandLine::remove_option(const CommandOption* option) {
  parser_->remove_option(&option->option_);
}

void CommandLine::parse_args(const std::vector<std::string>& args) {
  try {
    parser_->parse(std::vector<std::string>(args.rbegin(), args.rend()));
  } catch (const CLI::CallForHelp&) {
    std::printf("%s", parser_->help().c_str());
    throw NothingToDo{};
  } catch (const CLI::CallForVersion&) {
    std::printf("terrview %s\n", kVersion);
    throw NothingToDo{};
  } catch (const CLI::ParseError& error) {
    throw InputError(explain(error, *parser_));
  }
}

std::size_t CommandLine::count(const std::string& name) const { return parser_->count(name); }

std::vector<OptionDefinition> CommandLine::definitions() const {
  std::vector<OptionDefinition> definitions;
  const CLI::App& parser = *parser_;
  for (const CLI::Option* option : parser.get_options())
    if (option->nonpositional() && option != parser.get_version_ptr())
      definitions.push_back(definition_of(*option));
  return definitions;
}

CommandOption* CommandLine::known(CLI::Option* option) {
  options_.push_back(std::make_unique<CommandOption>(*option));
  return options_.back().get();
}

}  // namespace terrview

#include "cli/batch/option_values.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <set>

#include "cli/command_line.h"
#include "cli/nearest_name.h"
#include "cli/parse.h"
#include "cli/view_options.h"
#include "terrain/error.h"

namespace terrview {
namespace {

// How the program behaves, whatever the view; and the picture, which -o names for all.
const std::set<std::string> kBehaviour{"o",        "overwrite",   "threads", "quiet",
                                       "progress", "progressive", "help"};

bool is_number(const std::string& text) {
  char* end = nullptr;
  static_cast<void>(std::strtod(text.c_str(), &end));
  return !text.empty() && *end == '\0';
}

}  // namespace

struct ViewVocabulary::Definitions {
  std::map<std::string, OptionDefinition> by_name;
  std::set<std::string> reading;  // of DEMs
};

ViewVocabulary::ViewVocabulary() : definitions_(std::make_unique<Definitions>()) {
  CommandLine app("", "terrview view");
  ViewOptions options;
  add_view_options(app, options);
  for (const OptionDefinition& option : app.definitions())
    definitions_->by_name[option.name] = option;
  CommandLine dem_app("", "terrview view");
  std::vector<std::string> dems;
  DemOptions reading;
  add_dem_options(dem_app, dems, reading);
  for (const OptionDefinition& option : dem_app.definitions())
    definitions_->reading.insert(option.name);
}

ViewVocabulary::~ViewVocabulary() = default;

const OptionDefinition& ViewVocabulary::option(const std::string& name) const {
  return definitions_->by_name.at(name);
}

OptionValues ViewVocabulary::given(const CommandLine& parsed) const {
  OptionValues values;
  for (const OptionDefinition& option : parsed.definitions())
    if (!option.values.empty() && definitions_->by_name.count(option.name) > 0)
      values[option.name] = option.values;
  return values;
}

std::optional<std::string> ViewVocabulary::option_of(const std::string& column) const {
  std::string name = column;
  std::replace(name.begin(), name.end(), '_', '-');
  if (definitions_->by_name.count(name) == 0 || name.size() < 2) return std::nullopt;
  return name;
}

std::string ViewVocabulary::nearest(const std::string& column) const {
  std::vector<std::string> columns;
  for (const std::string& name : names())
    if (!is_common(name)) columns.push_back(name);
  return nearest_name(columns, column);
}

bool ViewVocabulary::is_common(const std::string& option) const {
  return kBehaviour.count(option) > 0 || definitions_->reading.count(option) > 0;
}

bool ViewVocabulary::is_behaviour(const std::string& option) const {
  return kBehaviour.count(option) > 0;
}

bool ViewVocabulary::is_flag(const std::string& name) const { return option(name).is_flag; }

bool ViewVocabulary::names_file(const std::string& name, const std::string& value) const {
  const std::string kinds = "|" + option(name).type_name + "|";
  const auto is_kind = [&](const std::string& kind) {
    return kinds.find("|" + kind + "|") != std::string::npos;
  };
  if (!(is_kind("FILE") || is_kind("IMAGE")) || is_kind(value)) return false;
  return !is_kind("LEVEL") || !is_number(value);
}

std::vector<std::string> ViewVocabulary::names() const {
  std::vector<std::string> names;
  for (const auto& [name, unused] : definitions_->by_name) names.push_back(name);
  return names;
}

void ViewVocabulary::set(const std::string& name, const std::vector<std::string>& cell,
                         OptionValues& values) const {
  const OptionDefinition& known = option(name);
  if (known.is_flag) {
    const std::string word = lower_case(cell.front());
    if (cell.size() != 1 || (word != "true" && word != "false"))
      throw InputError("--" + name + " " + cell.front() + ": give true, false or nothing");
    values.erase(name);
    if (word == "true") values[name] = {"true"};
    return;
  }
  values[name] = cell;
  if (known.takes_all || cell.size() == 1) return;
  const auto with_comma = [](const std::string& a, const std::string& b) { return a + "," + b; };
  values[name] = {std::accumulate(cell.begin() + 1, cell.end(), cell.front(), with_comma)};
}

OptionValues ViewVocabulary::with_row(OptionValues values, const JobRow& row) const {
  OptionValues said;
  for (const auto& [column, cell] : row.cells) {
    const auto name = option_of(column);
    if (!name) continue;
    said.erase(*name);
    set(*name, cell, values);
    if (values.count(*name) > 0) said[*name] = values[*name];
  }
  for (const auto& [name, unused] : said) {
    for (const std::string& excluded : option(name).excludes)
      if (said.count(excluded) == 0) values.erase(excluded);
  }
  return values;
}

std::vector<std::string> ViewVocabulary::arguments(const OptionValues& values,
                                                   const std::vector<std::string>& dems) const {
  std::vector<std::string> args;
  for (const auto& [name, all] : values) {
    const bool is_short = name.size() == 1;
    for (const std::string& value : all) {
      if (option(name).is_flag)
        args.push_back("--" + name);
      else
        args.push_back(is_short ? "-" + name + value : "--" + name + "=" + value);
    }
  }
  args.emplace_back("--");
  args.insert(args.end(), dems.begin(), dems.end());
  return args;
}

}  // namespace terrview

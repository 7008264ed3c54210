#include "cli/field_arguments.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

#include <nlohmann/json.hpp>

#include "cli/command_line.h"
#include "cli/parse.h"
#include "terrain/error.h"

namespace terrview {
namespace {

constexpr const char* kHForm = "give H from -1 to 2, or H,N:H,... with N the division it begins at";

const std::map<std::string, FieldKind> kKinds{{"midpoint", FieldKind::midpoint},
                                              {"displaced", FieldKind::displaced},
                                              {"smooth", FieldKind::smooth}};
const std::map<std::string, Law> kLaws{{"gaussian", Law::gaussian},
                                       {"uniform", Law::uniform},
                                       {"laplace", Law::laplace},
                                       {"coin", Law::coin}};

template <class Value>
std::string name_of(const std::map<std::string, Value>& names, Value value) {
  return std::find_if(names.begin(), names.end(),
                      [&](const auto& entry) { return entry.second == value; })
      ->first;
}

[[noreturn]] void refuse(const std::string& option, const std::string& text,
                         const std::string& remedy) {
  throw InputError(option + " " + text + ": " + remedy);
}

int parse_division(const std::string& option, const std::string& text, const std::string& part,
                   const std::string& remedy) {
  int value = 0;
  const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
  if (part.empty() || error != std::errc() || end != part.data() + part.size() || value < 0 ||
      value > RandomField::kMostLevels)
    refuse(option, text, remedy);
  return value;
}

}  // namespace

std::vector<double> parse_h(const std::string& text) {
  std::vector<double> h;
  std::size_t start = 0;
  while (start <= text.size()) {
    const std::size_t comma = std::min(text.find(',', start), text.size());
    std::string part = text.substr(start, comma - start);
    start = comma + 1;
    const std::size_t colon = part.find(':');
    if ((colon == std::string::npos) != h.empty()) refuse("--h", text, kHForm);
    if (colon != std::string::npos) {
      const int from = parse_division("--h", text, part.substr(0, colon), kHForm);
      if (from < static_cast<int>(h.size())) refuse("--h", text, kHForm);
      h.resize(static_cast<std::size_t>(from), h.back());
      part = part.substr(colon + 1);
    }
    const double value = parse_number("--h", part);
    if (value < -1 || value > 2) refuse("--h", text, kHForm);
    h.push_back(value);
  }
  return h;
}

glm::ivec2 parse_levels(const std::string& text) {
  const std::string remedy =
      "give N or NX:NY, whole numbers from 0 to " + std::to_string(RandomField::kMostLevels);
  const std::size_t colon = text.find(':');
  const int x = parse_division("--levels", text, text.substr(0, colon), remedy);
  if (colon == std::string::npos) return {x, x};
  return {x, parse_division("--levels", text, text.substr(colon + 1), remedy)};
}

std::uint64_t parse_seed(const std::string& option, const std::string& text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || error != std::errc() || end != text.data() + text.size())
    refuse(option, text, "give a whole number, 0 or more");
  return value;
}

void add_field_options(CommandLine& app, FieldOptions& options) {
  app.add_option_function<std::string>(
         "--seed", [&](const std::string& text) { options.seed = parse_seed("--seed", text); },
         "Another number, another field (default 1)")
      ->type_name("N");
  app.add_option_function<std::string>(
         "--h", [&](const std::string& text) { options.h = parse_h(text); },
         "0 rough to 1 soft; by division: 0,8:0.3 is 0 up to 7, then 0.3")
      ->type_name("H[,N:H...]");
  app.add_option_function<std::string>(
         "--levels", [&](const std::string& text) { options.levels = parse_levels(text); },
         "Divisions of a root cell, along x and y")
      ->type_name("N|NX:NY");
  app.add_option_function<std::string>(
         "--field", [&](const std::string& text) { options.kind = kKinds.at(text); },
         "How a cell is divided: the middles displaced, every vertex, or without creases")
      ->one_of(kKinds)
      ->type_name("midpoint|displaced|smooth");
  app.add_option_function<std::string>(
         "--law", [&](const std::string& text) { options.law = kLaws.at(text); },
         "The draws' law (default gaussian)")
      ->one_of(kLaws)
      ->type_name("gaussian|uniform|laplace|coin");
}

nlohmann::ordered_json field_json(const FieldOptions& options) {
  return {{"seed", options.seed},
          {"levels", {options.levels.x, options.levels.y}},
          {"h", options.h},
          {"kind", name_of(kKinds, options.kind)},
          {"law", name_of(kLaws, options.law)}};
}

}  // namespace terrview

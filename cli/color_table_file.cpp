#include "cli/color_table_file.h"

#include <array>
#include <cmath>
#include <fstream>
#include <iterator>

#include <nlohmann/json.hpp>

#include "terrain/error.h"

namespace terrview {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<const char*, 3> kComponents{"red", "green", "blue"};

std::vector<RampStop> parse_ramp(const Json& json, const std::string& where) {
  const std::string form = where + ": give stops [[position 0-1, value 0-255], ...] by position";
  if (!json.is_array() || json.empty()) throw InputError(form);
  std::vector<RampStop> stops;
  for (const Json& pair : json) {
    if (!pair.is_array() || pair.size() != 2 || !pair[0].is_number() || !pair[1].is_number())
      throw InputError(form);
    const RampStop stop{pair[0].get<double>(), pair[1].get<double>() / 255};
    const double least = stops.empty() ? 0 : stops.back().position;
    if (!(stop.position >= least && stop.position <= 1 && stop.value >= 0 && stop.value <= 1))
      throw InputError(form);
    stops.push_back(stop);
  }
  return stops;
}

struct NamedNumber {
  const char* name;
  double& value;
  double least;
};

std::array<NamedNumber, 5> numbers_of(ColorTable& table) {
  return {{{"middle", table.window.middle, -10},
           {"width", table.window.width, 0},
           {"clear_until", table.clear_until, 0},
           {"cloud_from", table.cloud_from, 0},
           {"noise", table.noise, 0}}};
}

ColorTable from_json(const Json& json, const std::string& where) {
  if (!json.is_object()) throw InputError(where + ": is no table: give a JSON object");
  ColorTable table;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::string name = kComponents[k];
    if (!json.contains(name))
      throw InputError(where + ": lacks '" + name + "': give all of red, green and blue");
    table.ramps[k] = parse_ramp(json[name], where + ", " + name);
  }
  for (const NamedNumber& number : numbers_of(table)) {
    if (!json.contains(number.name)) continue;
    const Json& given = json[number.name];
    if (!given.is_number() || !(given.get<double>() >= number.least && given.get<double>() <= 10))
      throw InputError(where + ", " + number.name + ": give a number from " +
                       std::to_string(static_cast<int>(number.least)) + " to 10");
    number.value = given.get<double>();
  }
  return table;
}

}  // namespace

ColorTable parse_color_table(const std::string& text, const std::string& where) {
  try {
    return from_json(Json::parse(text), where);
  } catch (const nlohmann::json::exception&) {
    throw InputError(where + ": is no JSON: see docs/skies.md for a table");
  }
}

std::string color_table_json(const ColorTable& table) {
  Json json;
  for (std::size_t k = 0; k < 3; ++k) {
    Json stops = Json::array();
    for (const RampStop& stop : table.ramps[k]) stops.push_back({stop.position, stop.value * 255});
    json[kComponents[k]] = stops;
  }
  ColorTable copy = table;
  for (const NamedNumber& number : numbers_of(copy)) json[number.name] = number.value;
  return json.dump();
}

ColorTable find_color_table(const std::string& name_or_path, double clouds) {
  if (name_or_path == "sky") return sky_table(clouds);
  if (const auto table = named_table(name_or_path)) return *table;
  std::ifstream file(name_or_path, std::ios::binary);
  if (!file)
    throw InputError("--ramp " + name_or_path +
                     ": no such table: give sky, sunset, wood, marble or a JSON file");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  return parse_color_table(text, "'" + name_or_path + "'");
}

}  // namespace terrview

#include "cli/palette_file.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>

#include <nlohmann/json.hpp>

#include "cli/parse.h"
#include "terrain/error.h"

namespace terrview {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kGimpHeader = "GIMP Palette";

std::string extension(const std::string& path) {
  return lower_case(std::filesystem::path(path).extension().string());
}

[[noreturn]] void throw_damaged(const std::string& name, const std::string& where) {
  throw InputError("'" + name + "': " + where +
                   " is no colour: a colour is three whole numbers from 0 to 255");
}

std::optional<Rgb8> checked(long r, long g, long b) {
  for (const long component : {r, g, b})
    if (component < 0 || component > 255) return std::nullopt;
  return Rgb8(r, g, b);
}

Palette parse_gimp(std::string_view text, const std::string& name) {
  std::istringstream lines{std::string(text)};
  std::string line;
  Palette palette;
  for (int number = 1; std::getline(lines, line); ++number) {
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (number == 1 || first == std::string::npos || line[first] == '#') continue;
    if (palette.empty() && (line.starts_with("Name:") || line.starts_with("Columns:"))) continue;
    std::istringstream numbers(line);
    long r = 0;
    long g = 0;
    long b = 0;
    numbers >> r >> g >> b;
    const std::optional<Rgb8> color = numbers ? checked(r, g, b) : std::nullopt;
    if (!color) throw_damaged(name, "line " + std::to_string(number));
    palette.push_back(*color);
  }
  return palette;
}

std::optional<Rgb8> color_of(const Json& json) {
  if (!json.is_array() || json.size() != 3) return std::nullopt;
  for (const Json& component : json)
    if (!component.is_number_integer()) return std::nullopt;
  return checked(json[0].get<long>(), json[1].get<long>(), json[2].get<long>());
}

Palette parse_json(std::string_view text, const std::string& name) {
  const Json json = Json::parse(text, nullptr, /*allow_exceptions=*/false);
  if (!json.is_object() || !json.contains("colors") || !json["colors"].is_array())
    throw InputError("'" + name +
                     "': is no palette: it is neither a GIMP palette nor JSON with \"colors\"");
  Palette palette;
  for (const Json& entry : json["colors"]) {
    const std::optional<Rgb8> color = color_of(entry);
    if (!color) throw_damaged(name, "entry " + std::to_string(palette.size()));
    palette.push_back(*color);
  }
  return palette;
}

std::string gimp_text(const Palette& palette, const std::string& path) {
  std::string text = std::string(kGimpHeader) +
                     "\nName: " + std::filesystem::path(path).stem().string() +
                     "\nColumns: 16\n#\n";
  for (const Rgb8 color : palette) {
    char line[40];
    std::snprintf(line, sizeof line, "%3d %3d %3d\t#%02x%02x%02x\n", color.r, color.g, color.b,
                  color.r, color.g, color.b);
    text += line;
  }
  return text;
}

std::string json_text(const Palette& palette) {
  std::string text = "{\"colors\": [";
  for (std::size_t i = 0; i < palette.size(); ++i) {
    char entry[32];
    std::snprintf(entry, sizeof entry, "%s\n  [%d, %d, %d]", i == 0 ? "" : ",", palette[i].r,
                  palette[i].g, palette[i].b);
    text += entry;
  }
  return text + "\n]}\n";
}

}  // namespace

Palette parse_palette(std::string_view text, const std::string& name) {
  const Palette palette =
      text.starts_with(kGimpHeader) ? parse_gimp(text, name) : parse_json(text, name);
  if (palette.empty() || palette.size() > kMaxPaletteColors)
    throw InputError("'" + name + "': has " + std::to_string(palette.size()) +
                     " colours: a palette has 1 to 65536");
  return palette;
}

Palette read_palette(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  if (!stream) throw InputError("'" + path + "': cannot be read: name a palette, .gpl or .json");
  return parse_palette(text.str(), path);
}

void check_palette_name(const std::string& path) {
  if (!path.empty() && extension(path) != ".gpl" && extension(path) != ".json")
    throw InputError("'" + path + "': unknown kind of palette: end the name in .gpl or .json");
}

std::string palette_text(const Palette& palette, const std::string& path) {
  return extension(path) == ".gpl" ? gimp_text(palette, path) : json_text(palette);
}

}  // namespace terrview

#include "cli/parse.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>

#include "render/color_ramp.h"
#include "terrain/error.h"

namespace terrview {
namespace {

[[noreturn]] void refuse(const std::string& option, const std::string& text,
                         const std::string& remedy) {
  throw InputError(option + " " + text + ": " + remedy);
}

// The whole of `text` as a finite number; locales do not matter.
std::optional<double> number(std::string_view text) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts{""};
  for (const char c : text) {
    if (c == separator)
      parts.emplace_back();
    else if (c != ' ')
      parts.back() += c;
  }
  return parts;
}

double number_or_refuse(const std::string& option, const std::string& text, const std::string& part,
                        const std::string& form) {
  const auto value = number(part);
  if (!value) refuse(option, text, "'" + part + "' is not a number: give " + form);
  return *value;
}

// Two coordinates and a height; the height may be missing where `height_optional`.
struct Place {
  glm::dvec2 point;
  HeightText height{0, true};
};

Place parse_place(const std::string& option, const std::string& text, const std::string& form,
                  bool height_optional) {
  const auto parts = split(text, ',');
  if (parts.size() != 3 && !(height_optional && parts.size() == 2))
    refuse(option, text, "give " + form);
  Place place;
  place.point = {number_or_refuse(option, text, parts[0], form),
                 number_or_refuse(option, text, parts[1], form)};
  if (parts.size() == 3) place.height = parse_height(option, parts[2]);
  return place;
}

}  // namespace

std::string lower_case(std::string text) {
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

double parse_number(const std::string& option, const std::string& text) {
  const auto value = number(text);
  if (!value) refuse(option, text, "give a number");
  return *value;
}

double parse_visibility(const std::string& option, const std::string& text) {
  if (text == "inf") return std::numeric_limits<double>::infinity();
  const auto value = number(text);
  if (!value || *value <= 0) refuse(option, text, "give kilometres above 0, or inf for no air");
  return *value;
}

std::vector<double> parse_numbers(const std::string& option, const std::string& text,
                                  std::size_t fewest, std::size_t most) {
  const auto parts = split(text, ',');
  const std::string wanted = fewest == most
                                 ? std::to_string(fewest)
                                 : std::to_string(fewest) + " to " + std::to_string(most);
  const std::string form = wanted + " numbers parted by commas";
  if (parts.size() < fewest || parts.size() > most) refuse(option, text, "give " + form);
  std::vector<double> values;
  for (const std::string& part : parts)
    values.push_back(number_or_refuse(option, text, part, form));
  return values;
}

HeightText parse_height(const std::string& option, const std::string& text) {
  const auto value = number(text);
  if (!value) refuse(option, text, "not a height: give metres, or +METRES above the ground");
  return {*value, text.front() == '+'};
}

GeoPoint check_geo_point(const std::string& option, double latitude_deg, double longitude_deg) {
  const std::string text = std::to_string(latitude_deg) + "," + std::to_string(longitude_deg);
  if (std::abs(latitude_deg) > 90)
    refuse(option, text, "the latitude is beyond 90 degrees: the order is LAT,LON");
  if (std::abs(longitude_deg) > 360)
    refuse(option, text, "the longitude is beyond 360 degrees: the order is LAT,LON");
  return {latitude_deg, longitude_deg};
}

EyePlace parse_eye(const std::string& text) {
  const Place place = parse_place("--eye", text, "LAT,LON,ALT (degrees and metres)", false);
  return {.geographic = check_geo_point("--eye", place.point.x, place.point.y),
          .projected = {},
          .height_m = place.height.height_m,
          .above_ground = place.height.above_ground};
}

EyePlace parse_eye_xy(const std::string& text) {
  const Place place = parse_place("--eye-xy", text, "X,Y,Z in the DEM's coordinates", false);
  return {.geographic = {},
          .projected = place.point,
          .height_m = place.height.height_m,
          .above_ground = place.height.above_ground};
}

Target parse_look_at(const std::string& text) {
  const Place place = parse_place("--look-at", text, "LAT,LON or LAT,LON,ALT", true);
  return {check_geo_point("--look-at", place.point.x, place.point.y), {}, place.height};
}

Target parse_look_at_xy(const std::string& text) {
  const Place place = parse_place("--look-at-xy", text, "X,Y or X,Y,Z", true);
  return {{}, place.point, place.height};
}

glm::vec3 parse_color(const std::string& option, const std::string& text) {
  const auto values = parse_numbers(option, text, 3, 3);
  for (const double value : values) {
    if (value < 0 || value > 255) refuse(option, text, "give R,G,B from 0 to 255, as 180,200,220");
  }
  return from_srgb8(static_cast<float>(values[0]), static_cast<float>(values[1]),
                    static_cast<float>(values[2]));
}

glm::ivec2 parse_size(const std::string& text) {
  const auto parts = split(text, 'x');
  const auto whole = [&](const std::string& part) {
    int value = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
    if (part.empty() || error != std::errc() || end != part.data() + part.size())
      refuse("--size", text, "give WIDTHxHEIGHT in pixels, as 1280x720");
    return value;
  };
  if (parts.size() != 2) refuse("--size", text, "give WIDTHxHEIGHT in pixels, as 1280x720");
  return {whole(parts[0]), whole(parts[1])};
}

std::pair<std::string, std::string> parse_creation_option(const std::string& text) {
  const auto equals = text.find('=');
  if (equals == std::string::npos || equals == 0) refuse("--co", text, "give KEY=VALUE");
  return {text.substr(0, equals), text.substr(equals + 1)};
}

glm::dvec2 parse_shift(const std::string& text) {
  const auto shares = parse_numbers("--shift", text, 2, 2);
  return {shares[0], shares[1]};
}

namespace {

std::array<int, 4> whole_numbers(const std::string& option, const std::string& text,
                                 const char* advice) {
  const auto values = parse_numbers(option, text, 4, 4);
  std::array<int, 4> numbers{};
  for (std::size_t i = 0; i < 4; ++i) {
    if (values[i] != std::floor(values[i]) || std::abs(values[i]) > 2e9)
      refuse(option, text, advice);
    numbers[i] = static_cast<int>(values[i]);
  }
  return numbers;
}

}  // namespace

PixelRect parse_crop(const std::string& text) {
  const auto [x, y, width, height] =
      whole_numbers("--crop", text, "give whole numbers: X,Y,WIDTH,HEIGHT in pixels");
  return {{x, y}, {width, height}};
}

std::array<int, 4> parse_window(const std::string& text) {
  return whole_numbers("--window", text, "give whole numbers: COLUMN,ROW,WIDTH,HEIGHT in posts");
}

}  // namespace terrview

#include "ingest/color_ramp_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <optional>
#include <span>
#include <vector>

#include "terrain/error.h"

namespace terrview {
namespace {

struct NamedColor {
  std::string_view name;
  std::array<float, 3> srgb8;
};

// The names that gdaldem knows, with its values.
constexpr std::array kNames{
    NamedColor{"white", {255, 255, 255}},  NamedColor{"black", {0, 0, 0}},
    NamedColor{"red", {255, 0, 0}},        NamedColor{"green", {0, 255, 0}},
    NamedColor{"blue", {0, 0, 255}},       NamedColor{"yellow", {255, 255, 0}},
    NamedColor{"magenta", {255, 0, 255}},  NamedColor{"cyan", {0, 255, 255}},
    NamedColor{"aqua", {0, 255, 255}},     NamedColor{"grey", {128, 128, 128}},
    NamedColor{"gray", {128, 128, 128}},   NamedColor{"orange", {255, 165, 0}},
    NamedColor{"brown", {150, 75, 0}},     NamedColor{"purple", {128, 0, 128}},
    NamedColor{"violet", {238, 130, 238}}, NamedColor{"indigo", {75, 0, 130}},
};

using Fields = std::vector<std::string_view>;

Fields split(std::string_view line, std::string_view separators) {
  Fields fields;
  while (true) {
    const auto begin = line.find_first_not_of(separators);
    if (begin == std::string_view::npos) return fields;
    line.remove_prefix(begin);
    const auto end = std::min(line.size(), line.find_first_of(separators));
    fields.push_back(line.substr(0, end));
    line.remove_prefix(end);
  }
}

std::string lower_case(std::string_view text) {
  std::string lower;
  for (const char c : text) {
    lower += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return lower;
}

std::optional<double> to_number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || std::isnan(number)) {
    return std::nullopt;
  }
  return number;
}

class RampParser {
 public:
  RampParser(const std::string& name, HeightRange range) : name_(name), range_(range) {}

  ColorRamp parse(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    while (!text.empty()) {
      ++line_number_;
      const auto end = std::min(text.size(), text.find('\n'));
      take_line(text.substr(0, end));
      text.remove_prefix(std::min(text.size(), end + 1));
    }
    if (ramp_.stops.empty()) throw InputError(name_ + ": holds no colours: " + kUsage);
    std::stable_sort(ramp_.stops.begin(), ramp_.stops.end(),
                     [](const auto& a, const auto& b) { return a.height_m < b.height_m; });
    return std::move(ramp_);
  }

 private:
  static constexpr const char* kUsage = "write lines of HEIGHT RED GREEN BLUE, as for gdaldem";

  [[noreturn]] void refuse(const std::string& what) const {
    throw InputError(name_ + ": line " + std::to_string(line_number_) + ": " + what + ": " +
                     kUsage);
  }

  void take_line(std::string_view line) {
    while (!line.empty() && static_cast<unsigned char>(line.back()) <= ' ') line.remove_suffix(1);
    if (line.starts_with("# QGIS")) qgis_ = true;
    if (line.empty() || line.starts_with('#')) return;
    if (line.starts_with("INTERPOLATION:")) {
      qgis_ = true;
      take_interpolation(line.substr(line.find(':') + 1));
      return;
    }
    const Fields fields = split(line, qgis_ ? "," : " ,\t:");
    if (fields.empty() || lower_case(fields[0]) == "nv") return;
    ramp_.stops.push_back({to_height(fields[0]), to_color(fields)});
  }

  void take_interpolation(std::string_view kind) {
    if (kind == "INTERPOLATED") {
      ramp_.interpolation = RampInterpolation::linear;
    } else if (kind == "DISCRETE") {
      ramp_.interpolation = RampInterpolation::discrete;
    } else if (kind == "EXACT") {
      ramp_.interpolation = RampInterpolation::exact;
    } else {
      refuse("unknown interpolation '" + std::string(kind) +
             "' (there are INTERPOLATED, DISCRETE and EXACT)");
    }
  }

  [[nodiscard]] double to_height(std::string_view text) const {
    const bool percent = text.ends_with('%');
    const auto number = to_number(percent ? text.substr(0, text.size() - 1) : text);
    if (!number) refuse("'" + std::string(text) + "' is no height");
    // QGIS gives the last class of a discrete map the value inf.
    if (std::isinf(*number) && ramp_.interpolation != RampInterpolation::discrete) {
      refuse("colours cannot be interpolated to an infinite height");
    }
    if (!percent) return *number;
    if (*number < 0 || *number > 100)
      refuse("'" + std::string(text) + "' is not within 0% to 100%");
    const double low = range_.lowest_m;
    return low + (range_.highest_m - low) * *number / 100;
  }

  [[nodiscard]] glm::vec3 to_color(std::span<const std::string_view> fields) const {
    if (fields.size() == 2 || fields.size() == 3) return named(fields[1]);
    if (fields.size() < 4) refuse("names no colour");
    // A line of a GMT table holds two heights, each with its colour.
    if (!qgis_ && fields.size() >= 8 && to_number(fields[7])) refuse("holds two colours");
    return from_srgb8(component(fields[1]), component(fields[2]), component(fields[3]));
  }

  [[nodiscard]] glm::vec3 named(std::string_view text) const {
    const std::string lower = lower_case(text);
    const auto* found = std::find_if(kNames.begin(), kNames.end(),
                                     [&](const NamedColor& color) { return color.name == lower; });
    if (found == kNames.end()) refuse("'" + std::string(text) + "' is no colour");
    return from_srgb8(found->srgb8[0], found->srgb8[1], found->srgb8[2]);
  }

  [[nodiscard]] float component(std::string_view text) const {
    const auto number = to_number(text);
    if (!number || *number < 0 || *number > 255) {
      refuse("'" + std::string(text) + "' is not within 0 to 255");
    }
    return static_cast<float>(*number);
  }

  const std::string& name_;
  HeightRange range_;
  ColorRamp ramp_;
  bool qgis_ = false;
  int line_number_ = 0;
};

}  // namespace

ColorRamp parse_color_ramp(std::string_view text, const std::string& name, HeightRange range) {
  return RampParser(name, range).parse(text);
}

ColorRamp read_color_ramp(const std::string& path, HeightRange range) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError(path + ": cannot be read: check the path given with --colors");
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  return parse_color_ramp(text, path, range);
}

}  // namespace terrview

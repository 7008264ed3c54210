#include "ingest/feature_attributes.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>

#include "render/color_ramp.h"

namespace terrview {
namespace {

std::string plain(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (!std::isspace(static_cast<unsigned char>(c)))
      result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return result;
}

// The number at the front of `text`, which is cut off it.
std::optional<double> take_number(std::string_view& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

constexpr std::array<std::pair<std::string_view, unsigned>, 17> kNames{{{"black", 0x000000},
                                                                        {"silver", 0xc0c0c0},
                                                                        {"gray", 0x808080},
                                                                        {"grey", 0x808080},
                                                                        {"white", 0xffffff},
                                                                        {"maroon", 0x800000},
                                                                        {"red", 0xff0000},
                                                                        {"purple", 0x800080},
                                                                        {"fuchsia", 0xff00ff},
                                                                        {"green", 0x008000},
                                                                        {"lime", 0x00ff00},
                                                                        {"olive", 0x808000},
                                                                        {"yellow", 0xffff00},
                                                                        {"navy", 0x000080},
                                                                        {"blue", 0x0000ff},
                                                                        {"teal", 0x008080},
                                                                        {"aqua", 0x00ffff}}};

glm::vec3 linear(double red, double green, double blue) {
  return from_srgb8(static_cast<float>(red), static_cast<float>(green), static_cast<float>(blue));
}

glm::vec3 linear(unsigned rgb) { return linear(rgb >> 16U, rgb >> 8U & 255U, rgb & 255U); }

std::optional<glm::vec3> hexadecimal(std::string_view digits) {
  unsigned value = 0;
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
  if (error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
  if (digits.size() == 6) return linear(value);
  if (digits.size() != 3) return std::nullopt;
  return linear(17.0 * (value >> 8U), 17.0 * (value >> 4U & 15U), 17.0 * (value & 15U));
}

}  // namespace

std::optional<double> length_of(const std::string& text) {
  const std::string compact = plain(text);
  std::string_view rest = compact;
  const auto number = take_number(rest);
  if (!number) return std::nullopt;
  if (rest.empty() || rest == "m") return number;
  constexpr double kFoot_m = 0.3048;
  if (rest == "ft" || rest == "'") return *number * kFoot_m;
  return std::nullopt;
}

std::optional<glm::vec3> color_of(const std::string& text) {
  const std::string compact = plain(text);
  if (!compact.empty() && compact[0] == '#')
    return hexadecimal(std::string_view(compact).substr(1));
  for (const auto& [name, rgb] : kNames)
    if (name == compact) return linear(rgb);
  std::string_view rest = compact;
  std::array<double, 3> rgb{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto number = take_number(rest);
    if (!number || *number < 0 || *number > 255) return std::nullopt;
    rgb[i] = *number;
    const bool parted = i < 2 && !rest.empty() && rest[0] == ',';
    if (i < 2 && !parted) return std::nullopt;
    if (parted) rest.remove_prefix(1);
  }
  if (!rest.empty()) return std::nullopt;
  return linear(rgb[0], rgb[1], rgb[2]);
}

std::optional<double> azimuth_deg_of(const std::string& text) {
  const std::string compact = plain(text);
  std::string_view rest = compact;
  if (const auto number = take_number(rest)) {
    if (!rest.empty()) return std::nullopt;
    return number;
  }
  constexpr std::array<std::string_view, 16> kPoints{"n",  "nne", "ne", "ene", "e",  "ese",
                                                     "se", "sse", "s",  "ssw", "sw", "wsw",
                                                     "w",  "wnw", "nw", "nnw"};
  const auto* point = std::find(kPoints.begin(), kPoints.end(), compact);
  if (point == kPoints.end()) return std::nullopt;
  return 22.5 * static_cast<double>(point - kPoints.begin());
}

}  // namespace terrview

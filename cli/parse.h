// Texts of the command line to values. Every function throws InputError naming the option.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "ingest/view_frame.h"
#include "render/camera.h"

namespace terrview {

// ASCII letters in lower case.
[[nodiscard]] std::string lower_case(std::string text);

// The whole of `text` as a finite number.
[[nodiscard]] double parse_number(const std::string& option, const std::string& text);

// A visibility in kilometres: a number above 0, or inf.
[[nodiscard]] double parse_visibility(const std::string& option, const std::string& text);

// Numbers parted by commas, between `fewest` and `most` of them.
[[nodiscard]] std::vector<double> parse_numbers(const std::string& option, const std::string& text,
                                                std::size_t fewest, std::size_t most);

// A height: absolute, or above the ground where it begins with '+'.
struct HeightText {
  double height_m;
  bool above_ground;
};
[[nodiscard]] HeightText parse_height(const std::string& option, const std::string& text);

// LAT,LON in degrees; checks their ranges.
[[nodiscard]] GeoPoint check_geo_point(const std::string& option, double latitude_deg,
                                       double longitude_deg);

// --eye LAT,LON,ALT and --eye-xy X,Y,Z; ALT and Z may be +H.
[[nodiscard]] EyePlace parse_eye(const std::string& text);
[[nodiscard]] EyePlace parse_eye_xy(const std::string& text);

// --look-at LAT,LON[,ALT] and --look-at-xy X,Y[,Z]; without a height, the ground there.
struct Target {
  std::optional<GeoPoint> geographic;
  std::optional<glm::dvec2> projected;
  HeightText height{0, true};
};
[[nodiscard]] Target parse_look_at(const std::string& text);
[[nodiscard]] Target parse_look_at_xy(const std::string& text);

// An ISO 8601 date and time, 2026-06-21T15:00Z or with an offset as +02:00, as a Julian day of UTC.
[[nodiscard]] double parse_time(const std::string& text);

// R,G,B from 0 to 255, sRGB; the result is linear.
[[nodiscard]] glm::vec3 parse_color(const std::string& option, const std::string& text);

// WxH.
[[nodiscard]] glm::ivec2 parse_size(const std::string& text);

// X,Y of --shift.
[[nodiscard]] glm::dvec2 parse_shift(const std::string& text);

// X,Y,W,H of --crop.
[[nodiscard]] PixelRect parse_crop(const std::string& text);

// KEY=VALUE.
[[nodiscard]] std::pair<std::string, std::string> parse_creation_option(const std::string& text);

// COL,ROW,W,H.
[[nodiscard]] std::array<int, 4> parse_window(const std::string& text);

}  // namespace terrview

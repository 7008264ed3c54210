#include "cli/impact/report_numbers.h"

#include <cmath>
#include <cstdio>

#include "cli/impact/html_text.h"

namespace terrview {

std::string fixed_number(double value, int decimals) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

std::string short_number(double value) {
  if (!(std::abs(value) > 0)) return "0";
  constexpr double kHundred = 99.95;
  if (std::abs(value) >= kHundred) return fixed_number(value, 0);
  char text[64];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

std::string percent(const std::optional<double>& share) {
  if (!share) return kNothing;
  return fixed_number(100 * *share, 1) + " %";
}

std::string length_text(double length_m) {
  return length_m < 1000 ? fixed_number(length_m, 0) + " m"
                         : fixed_number(length_m / 1000, 2) + " km";
}

std::string place_words(PlanPlace place, bool geographic) {
  if (!geographic) return "x " + fixed_number(place.x, 1) + ", y " + fixed_number(place.y, 1);
  constexpr int kDecimals = 6;
  return fixed_number(std::abs(place.y), kDecimals) + (place.y < 0 ? "° S, " : "° N, ") +
         fixed_number(std::abs(place.x), kDecimals) + (place.x < 0 ? "° W" : "° E");
}

std::string distance_text(const std::optional<StudyPoint>& point) {
  return point ? length_text(point->distance_m) : kNothing;
}

std::string solid_angle_text(double solid_angle_sr) { return short_number(1000 * solid_angle_sr); }

std::string cell(const std::string& text) {
  return "<td class=\"name\">" + html_text(text) + "</td>";
}

std::string number_cell(const std::string& text) {
  return "<td class=\"n\">" + html_text(text) + "</td>";
}

std::string column_head(const std::string& text) {
  return "<th scope=\"col\">" + html_text(text) + "</th>";
}

std::string number_head(const std::string& text) {
  return "<th scope=\"col\" class=\"n\">" + html_text(text) + "</th>";
}

std::string pair(const std::string& name, const std::string& text) {
  return "<dt>" + html_text(name) + "</dt><dd>" + html_text(text) + "</dd>\n";
}

}  // namespace terrview

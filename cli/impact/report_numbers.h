// Numbers of a study as a reader takes them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/impact/impact_study.h"

namespace terrview {

inline constexpr const char* kNothing = "\u2013";

// Three significant digits.
[[nodiscard]] std::string short_number(double value);
[[nodiscard]] std::string fixed_number(double value, int decimals);
// A share as per cent, with a decimal; none: a dash.
[[nodiscard]] std::string percent(const std::optional<double>& share);
// As 850 m or 12.3 km.
[[nodiscard]] std::string length_text(double length_m);
// As 47.13745° N, 9.51765° E; or x and y.
[[nodiscard]] std::string place_words(PlanPlace place, bool geographic);
// A distance, or a dash.
[[nodiscard]] std::string distance_text(const std::optional<StudyPoint>& point);
[[nodiscard]] std::string solid_angle_text(double solid_angle_sr);

// <td>s: a class of n is for numbers. `text` is no HTML yet.
[[nodiscard]] std::string cell(const std::string& text);
[[nodiscard]] std::string number_cell(const std::string& text);
// <th>s of columns, likewise.
[[nodiscard]] std::string column_head(const std::string& text);
[[nodiscard]] std::string number_head(const std::string& text);
// <dt> and <dd>.
[[nodiscard]] std::string pair(const std::string& name, const std::string& text);

}  // namespace terrview

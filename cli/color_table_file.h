// Colour tables as JSON:
//
//   {"red": [[0, 52], [0.42, 104], [1, 92]], "green": [...], "blue": [...],
//    "middle": 0.5, "width": 0.18, "clear_until": 0.42, "cloud_from": 0.64, "noise": 0}
//
// Stops are [position 0-1, sRGB 0-255] by rising position; two at one position make a jump. What is
// not a ramp may be left out.
#pragma once

#include <string>

#include "sky/color_table.h"

namespace terrview {

// Throws InputError naming `where` for text that is no table.
[[nodiscard]] ColorTable parse_color_table(const std::string& text, const std::string& where);
[[nodiscard]] std::string color_table_json(const ColorTable& table);

// The named table, or that of a JSON file. `sky` is the standard one, its window that of `clouds`.
// Throws InputError.
[[nodiscard]] ColorTable find_color_table(const std::string& name_or_path, double clouds);

}  // namespace terrview

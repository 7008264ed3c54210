// Palettes as files: GIMP's .gpl and JSON.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "quantize/color.h"

namespace terrview {

// `text` is a GIMP palette or the JSON {"colors": [[r, g, b], ...]}, whichever it looks like;
// `name` is for messages. Throws InputError unless there are 1 to 65536 colours.
[[nodiscard]] Palette parse_palette(std::string_view text, const std::string& name);

// Throws InputError also if the file cannot be read.
[[nodiscard]] Palette read_palette(const std::string& path);

// Throws InputError unless the name ends in .gpl or .json.
void check_palette_name(const std::string& path);

// What a file of that name holds.
[[nodiscard]] std::string palette_text(const Palette& palette, const std::string& path);

}  // namespace terrview

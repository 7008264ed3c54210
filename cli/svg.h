// What SVG files have in common.
#pragma once

#include <string>

#include <glm/vec2.hpp>

namespace terrview {

// UTF-8 as the text of an element, or between quotes, of XML and of HTML. Control characters,
// U+FFFE and U+FFFF, which these have not, become U+FFFD.
[[nodiscard]] std::string xml_text(const std::string& text);

// A drawing to lay over a picture of `size_px`, one unit a pixel; `metadata` says what made it.
[[nodiscard]] std::string svg_file(glm::ivec2 size_px, const std::string& metadata,
                                   const std::string& elements);

// With that many decimals, without zeros at their end.
[[nodiscard]] std::string svg_number(double value, int decimals);

}  // namespace terrview

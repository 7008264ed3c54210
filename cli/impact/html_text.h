// Texts and bytes as HTML takes them.
#pragma once

#include <string>
#include <string_view>

namespace terrview {

// With U+FFFD for what is no UTF-8.
[[nodiscard]] std::string utf8_text(const std::string& text);

// xml_text() of any bytes: what is no UTF-8 becomes U+FFFD.
[[nodiscard]] std::string html_text(const std::string& text);

// The bytes of a file within a page.
[[nodiscard]] std::string data_uri(const std::string& media_type, std::string_view bytes);

}  // namespace terrview

#include "cli/svg.h"

#include <cstdio>
#include <string_view>

namespace terrview {
namespace {

constexpr const char* kReplacement = "\xef\xbf\xbd";

// What stands for a character that cannot stand for itself; null for others.
const char* stand_in(char c) {
  switch (c) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    case '\'':
      return "&#39;";
    case '\n':
    case '\t':
      return nullptr;
    default:
      return static_cast<unsigned char>(c) < ' ' || c == '\x7f' ? kReplacement : nullptr;
  }
}

}  // namespace

std::string xml_text(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::string_view three = std::string_view(text).substr(i, 3);
    if (three == "\xef\xbf\xbe" || three == "\xef\xbf\xbf") {
      result += kReplacement;
      i += 2;
    } else if (const char* other = stand_in(text[i])) {
      result += other;
    } else {
      result += text[i];
    }
  }
  return result;
}

std::string svg_file(glm::ivec2 size_px, const std::string& metadata, const std::string& elements) {
  const std::string width = std::to_string(size_px.x);
  const std::string height = std::to_string(size_px.y);
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" "
         "width=\"" +
         width + "\" height=\"" + height + "\" viewBox=\"0 0 " + width + " " + height +
         "\">\n<metadata>" + xml_text(metadata) + "</metadata>\n" + elements + "</svg>\n";
}

std::string svg_number(double value, int decimals) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%.*f", decimals, value);
  std::string text = buffer;
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

}  // namespace terrview

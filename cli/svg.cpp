#include "cli/svg.h"

#include <cstdio>

namespace terrview {

std::string xml_text(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '"')
      result += "&quot;";
    else if (text.compare(i, 2, "\xef\xbf") == 0 && i + 2 < text.size() &&
             static_cast<unsigned char>(text[i + 2]) >= 0xbe)
      i += 2;  // U+FFFE and U+FFFF are no XML
    else
      result += c;
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

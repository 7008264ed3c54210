#include "cli/impact/html_text.h"

#include <cstdint>

#include <nlohmann/json.hpp>

#include "cli/svg.h"

namespace terrview {
namespace {

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t triple = 0;
    for (std::size_t j = 0; j < 3; ++j)
      triple = triple << 8 | (i + j < bytes.size() ? static_cast<unsigned char>(bytes[i + j]) : 0U);
    for (std::size_t j = 0; j < 4; ++j)
      text += i + j <= bytes.size() ? kDigits[triple >> (18 - 6 * j) & 63U] : '=';
  }
  return text;
}

}  // namespace

std::string utf8_text(const std::string& text) {
  using Json = nlohmann::json;
  return Json::parse(Json(text).dump(-1, ' ', false, Json::error_handler_t::replace));
}

std::string html_text(const std::string& text) { return xml_text(utf8_text(text)); }

std::string data_uri(const std::string& media_type, std::string_view bytes) {
  return "data:" + media_type + ";base64," + base64(bytes);
}

}  // namespace terrview

#include "tests/cli/scene/schema_check.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <regex>
#include <stdexcept>

namespace terrview {
namespace {

using Json = nlohmann::ordered_json;

class Checker {
 public:
  explicit Checker(const Json& root) : root_(root) {}

  // The first keyword that the value does not obey, after its place.
  [[nodiscard]] std::string fault(const Json& schema, const Json& value,
                                  const std::string& place) const {
    for (const auto& [keyword, wanted] : schema.items()) {
      if (keyword == "$schema" || keyword == "title" || keyword == "description" ||
          keyword == "$defs")
        continue;
      const std::string found = by_keyword(schema, keyword, wanted, value, place);
      if (!found.empty()) return found;
    }
    return "";
  }

 private:
  [[nodiscard]] std::string by_keyword(const Json& schema, const std::string& keyword,
                                       const Json& wanted, const Json& value,
                                       const std::string& place) const {
    if (keyword == "$ref")
      return fault(root_.at(Json::json_pointer(wanted.get<std::string>().substr(1))), value, place);
    if (keyword == "oneOf") return one_of(wanted, value, place);
    if (keyword == "properties" || keyword == "additionalProperties")
      return members(schema, keyword, value, place);
    if (keyword == "items") return elements(wanted, value, place);
    return obeys(keyword, wanted, value) ? "" : place + ": " + keyword + " " + wanted.dump();
  }

  [[nodiscard]] std::string one_of(const Json& all, const Json& value,
                                   const std::string& place) const {
    const auto fits = [&](const Json& one) { return fault(one, value, place).empty(); };
    const auto count = std::count_if(all.begin(), all.end(), fits);
    return count == 1 ? "" : place + ": fits " + std::to_string(count) + " of oneOf";
  }

  [[nodiscard]] std::string members(const Json& schema, const std::string& keyword,
                                    const Json& value, const std::string& place) const {
    if (!value.is_object()) return "";
    const Json known = schema.value("properties", Json::object());
    for (const auto& [key, member] : value.items()) {
      const bool is_known = known.contains(key);
      if (is_known != (keyword == "properties")) continue;
      const Json& wanted = is_known ? known[key] : schema.at(keyword);
      if (wanted == false) return place + "/" + key + ": is not known";
      const std::string found = fault(wanted, member, place + "/" + key);
      if (!found.empty()) return found;
    }
    return "";
  }

  [[nodiscard]] std::string elements(const Json& wanted, const Json& value,
                                     const std::string& place) const {
    if (!value.is_array()) return "";
    for (std::size_t i = 0; i < value.size(); ++i) {
      const std::string found = fault(wanted, value[i], place + "/" + std::to_string(i));
      if (!found.empty()) return found;
    }
    return "";
  }

  static bool is_of_type(const std::string& type, const Json& value) {
    if (type == "integer") return value.is_number() && value == std::floor(value.get<double>());
    static const std::map<std::string, bool (Json::*)() const noexcept> types{
        {"object", &Json::is_object},
        {"array", &Json::is_array},
        {"string", &Json::is_string},
        {"number", &Json::is_number},
        {"boolean", &Json::is_boolean}};
    return (value.*types.at(type))();
  }

  static bool obeys(const std::string& keyword, const Json& wanted, const Json& value) {
    if (keyword == "type") return is_of_type(wanted, value);
    if (keyword == "const") return value == wanted;
    if (keyword == "enum") return std::find(wanted.begin(), wanted.end(), value) != wanted.end();
    if (keyword == "required")
      return !value.is_object() || std::all_of(wanted.begin(), wanted.end(), [&](const Json& key) {
        return value.contains(key.get<std::string>());
      });
    if (keyword == "minItems") return !value.is_array() || value.size() >= wanted;
    if (keyword == "maxItems") return !value.is_array() || value.size() <= wanted;
    if (keyword == "minimum") return !value.is_number() || value >= wanted;
    if (keyword == "maximum") return !value.is_number() || value <= wanted;
    if (keyword == "exclusiveMinimum") return !value.is_number() || value > wanted;
    if (keyword == "pattern")
      return !value.is_string() ||
             std::regex_search(value.get<std::string>(), std::regex(wanted.get<std::string>()));
    throw std::runtime_error("the schema has a keyword unknown here: " + keyword);
  }

  const Json& root_;
};

}  // namespace

std::string schema_fault(const Json& schema, const Json& value) {
  return Checker(schema).fault(schema, value, "");
}

}  // namespace terrview

#include "ingest/geojson_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include <cpl_vsi.h>
#include <nlohmann/json.hpp>

#include "terrain/error.h"

namespace terrview {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kDeepest = 32;

// How deep the arrays of a geometry's coordinates nest.
struct GeometryType {
  std::string_view name;
  int depth;
};
constexpr std::array<GeometryType, 7> kGeometries{{{"Point", 1},
                                                   {"LineString", 2},
                                                   {"MultiPoint", 2},
                                                   {"Polygon", 3},
                                                   {"MultiLineString", 3},
                                                   {"MultiPolygon", 4},
                                                   {"GeometryCollection", 0}}};

// Follows the parser and knows the feature that it is at.
class Checker : public nlohmann::json_sax<Json> {
 public:
  explicit Checker(const std::string& path) : path_(path) {}

  bool null() override { return is_geometry_member() || scalar(); }
  bool boolean(bool /*value*/) override { return scalar(); }
  bool number_integer(std::int64_t /*value*/) override { return number(0); }
  bool number_unsigned(std::uint64_t /*value*/) override { return number(0); }
  bool number_float(double value, const std::string& /*text*/) override { return number(value); }
  bool binary(binary_t& /*value*/) override { return true; }

  bool string(std::string& value) override {
    if (levels_.empty() || !levels_.back().is_geometry || key_ != "type") return scalar();
    const auto* type = std::find_if(kGeometries.begin(), kGeometries.end(),
                                    [&](const GeometryType& known) { return known.name == value; });
    if (type == kGeometries.end()) refuse("'" + value.substr(0, 40) + "' is no type of geometry");
    levels_.back().depth_due = type->depth;
    return true;
  }

  bool key(std::string& name) override {
    key_ = name;
    return true;
  }

  bool start_object(std::size_t /*size*/) override {
    if (is_position() || is_coordinates_member()) refuse("an object among its coordinates");
    begin_element();
    Level level{.is_array = false};
    if (!levels_.empty()) {
      level.is_geometry = is_geometry_member() || levels_.back().holds_geometries;
      level.is_feature = levels_.back().holds_features;
    }
    return push(level);
  }

  bool start_array(std::size_t /*size*/) override {
    Level level{.is_array = true};
    if (levels_.size() == 1 && key_ == "features") {
      level.holds_features = true;
    } else {
      if (!levels_.empty() && levels_.back().holds_features) {
        begin_element();
        refuse("is an array, not an object");
      }
      if (is_position()) {
        if (levels_.back().numbers > 0) refuse("an array among the numbers of a position");
        ++levels_.back().arrays;
      }
      level.in_coordinates = is_position() || is_coordinates_member();
      level.holds_geometries =
          !levels_.empty() && levels_.back().is_geometry && key_ == "geometries";
      if (is_geometry_member()) refuse("its geometry is an array, not an object");
    }
    return push(level);
  }

  bool end_object() override {
    const Level& level = levels_.back();
    if (level.is_geometry && level.depth_due < 0) refuse("its geometry has no type");
    if (level.is_geometry && level.depth > 0 && level.depth != level.depth_due)
      refuse("its coordinates do not nest as its type does");
    return pop();
  }

  bool end_array() override {
    const Level& level = levels_.back();
    if (level.in_coordinates && level.numbers == 1) refuse("a position of one number");
    return pop();
  }

  bool parse_error(std::size_t byte, const std::string& /*token*/,
                   const Json::exception& error) override {
    const bool too_large = dynamic_cast<const Json::out_of_range*>(&error) != nullptr;
    refuse(too_large ? "a number is too large (byte " + std::to_string(byte) + ")"
                     : "broken off, or no JSON, at byte " + std::to_string(byte));
  }

 private:
  struct Level {
    bool is_array = false;
    bool holds_features = false;
    bool is_feature = false;
    bool is_geometry = false;
    bool holds_geometries = false;
    bool in_coordinates = false;
    int numbers = 0;  // of its elements
    int arrays = 0;
    int depth = 0;  // of a geometry's positions
    int depth_due = -1;
  };

  [[noreturn]] void refuse(const std::string& what) const {
    throw InputError("'" + path_ + "'" +
                     (features_ > 0 ? ", feature " + std::to_string(features_) : "") + ": " + what +
                     ": mend the GeoJSON");
  }

  // Whether the value to come is a feature's geometry.
  [[nodiscard]] bool is_geometry_member() const {
    return !levels_.empty() && levels_.back().is_feature && key_ == "geometry";
  }
  // Whether it is a geometry's coordinates.
  [[nodiscard]] bool is_coordinates_member() const {
    return !levels_.empty() && levels_.back().is_geometry && key_ == "coordinates";
  }
  [[nodiscard]] bool is_position() const {
    return !levels_.empty() && levels_.back().in_coordinates;
  }

  void begin_element() {
    if (!levels_.empty() && levels_.back().holds_features) ++features_;
  }

  bool scalar() {
    if (!levels_.empty() && levels_.back().holds_features) {
      begin_element();
      refuse("is no object");
    }
    if (is_position() || is_coordinates_member()) refuse("its coordinates are not all numbers");
    if (is_geometry_member()) refuse("its geometry is no object");
    return true;
  }

  bool number(double value) {
    if (!is_position()) return scalar();
    if (!std::isfinite(value)) refuse("a coordinate is not finite");
    if (levels_.back().arrays > 0) refuse("a number among its positions");
    if (levels_.back().numbers++ == 0) note_depth();
    return true;
  }

  // Of a position, on the geometry that it belongs to.
  void note_depth() {
    std::size_t geometry = levels_.size() - 1;
    while (!levels_[geometry].is_geometry) --geometry;
    const int depth = static_cast<int>(levels_.size() - 1 - geometry);
    int& noted = levels_[geometry].depth;
    if (noted != 0 && noted != depth) refuse("its coordinates nest unevenly");
    noted = depth;
  }

  bool push(const Level& level) {
    if (levels_.size() >= kDeepest) refuse("nests deeper than " + std::to_string(kDeepest));
    levels_.push_back(level);
    return true;
  }

  bool pop() {
    levels_.pop_back();
    return true;
  }

  const std::string& path_;
  std::vector<Level> levels_;
  std::string key_;
  int features_ = 0;
};

bool is_json(const std::vector<char>& bytes) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  const std::string_view text(bytes.data(), bytes.size());
  std::size_t at = text.substr(0, kMark.size()) == kMark ? kMark.size() : 0;
  at = text.find_first_not_of(" \t\r\n", at);
  return at != std::string_view::npos && (text[at] == '{' || text[at] == '[');
}

std::vector<char> read_start(VSILFILE* file, std::size_t most) {
  std::vector<char> bytes(most);
  bytes.resize(VSIFReadL(bytes.data(), 1, most, file));
  return bytes;
}

struct Closing {
  void operator()(VSILFILE* file) const { VSIFCloseL(file); }
};

}  // namespace

void check_geojson(const std::string& path) {
  const std::unique_ptr<VSILFILE, Closing> file(VSIFOpenL(path.c_str(), "rb"));
  if (!file) return;
  constexpr std::size_t kStart_bytes = 4096;
  std::vector<char> bytes = read_start(file.get(), kStart_bytes);
  if (!is_json(bytes)) return;
  VSIFSeekL(file.get(), 0, SEEK_END);
  const auto size = static_cast<std::size_t>(VSIFTellL(file.get()));
  VSIFSeekL(file.get(), 0, SEEK_SET);
  bytes = read_start(file.get(), size);
  Checker checker(path);
  Json::sax_parse(bytes.begin(), bytes.end(), &checker);
}

}  // namespace terrview

#include "ingest/peaks.h"

#include <array>
#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>

#include <ogrsf_frmts.h>

#include "ingest/feature_attributes.h"
#include "terrain/error.h"

namespace terrview {
namespace {

using Names = std::vector<std::string_view>;

struct PlaceColumns {
  Names x;
  Names y;
  bool geographic;
};

const std::array<PlaceColumns, 2>& place_columns() {
  static const std::array<PlaceColumns, 2> columns{
      {{{"lon", "longitude"}, {"lat", "latitude"}, true}, {{"x"}, {"y"}, false}}};
  return columns;
}

double coordinate(const VectorFeature& feature, const std::string& text) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || rest != end)
    feature.refuse("the coordinate '" + text + "' is no number: write it as 47.0537");
  return value;
}

std::optional<double> length_in(const VectorFeature& feature, const Names& names) {
  const auto text = feature.text(names);
  return text ? length_of(*text) : std::nullopt;
}

class PeakReader {
 public:
  PeakFile read(const std::string& path) {
    result_.file = read_vector_file(path, [&](const VectorFeature& feature) { take(feature); });
    if (from_degrees_.value_or(false)) {
      result_.file.crs_wkt = "OGC:CRS84";
      result_.file.geographic = true;
    }
    if (result_.peaks.empty()) refuse();
    return std::move(result_);
  }

 private:
  void take(const VectorFeature& feature) {
    if (fields_.empty()) fields_ = feature.fields();
    const auto place = place_of(feature);
    if (!place) {
      ++result_.without_point;
      return;
    }
    check(feature, *place);
    Peak peak;
    peak.number = feature.number();
    peak.place = *place;
    peak.name = feature.line(Names{"name"});
    if (peak.name.empty()) {
      ++result_.without_name;
      return;
    }
    peak.elevation_m =
        length_in(feature, {"ele", "elevation", "elevation_m", "height", "height_m", "altitude"});
    peak.prominence_m = length_in(feature, {"prominence", "prominence_m"});
    result_.peaks.push_back(std::move(peak));
  }

  std::optional<glm::dvec2> place_of(const VectorFeature& feature) {
    const OGRGeometry* geometry = feature.geometry();
    if (geometry == nullptr) return place_in_columns(feature);
    if (wkbFlatten(geometry->getGeometryType()) != wkbPoint || geometry->IsEmpty() != 0)
      return std::nullopt;
    return glm::dvec2(geometry->toPoint()->getX(), geometry->toPoint()->getY());
  }

  std::optional<glm::dvec2> place_in_columns(const VectorFeature& feature) {
    for (const PlaceColumns& columns : place_columns()) {
      const auto x = feature.text(columns.x);
      const auto y = feature.text(columns.y);
      if (!x || !y) continue;
      if (from_degrees_.value_or(columns.geographic) != columns.geographic)
        feature.refuse("has x and y where others have lat and lon: give all the same");
      from_degrees_ = columns.geographic;
      const glm::dvec2 place(coordinate(feature, *x), coordinate(feature, *y));
      if (columns.geographic && !(std::abs(place.x) <= 360 && std::abs(place.y) <= 90))
        feature.refuse("latitude " + *y + ", longitude " + *x +
                       " is nowhere on the Earth: give degrees");
      return place;
    }
    return std::nullopt;
  }

  static void check(const VectorFeature& feature, glm::dvec2 place) {
    // Squares of what is left are numbers.
    constexpr double kFarthest = 1e9;
    if (!(std::abs(place.x) <= kFarthest && std::abs(place.y) <= kFarthest))
      feature.refuse("its coordinates are nowhere: mend them");
  }

  [[noreturn]] void refuse() const {
    const std::string seen = fields_.empty() ? "it has none" : "it has " + fields_;
    const std::string start = "'" + result_.file.name + "': ";
    if (result_.file.features == 0) throw InputError(start + "has no features: give summits");
    if (result_.without_name == 0)
      throw InputError(start +
                       "has neither points nor columns of coordinates: give lat and lon, "
                       "or x and y; " +
                       seen);
    throw InputError(start + "no summit has a name: give a field 'name'; " + seen);
  }

  PeakFile result_;
  std::optional<bool> from_degrees_;  // of a table; none: no row has told
  std::string fields_;
};

}  // namespace

PeakFile read_peaks(const std::string& path) { return PeakReader().read(path); }

}  // namespace terrview

#include "ingest/viewpoint_file.h"

#include <array>
#include <cmath>
#include <span>
#include <string_view>

#include <ogr_geometry.h>

#include "ingest/feature_attributes.h"
#include "ingest/feature_places.h"
#include "terrain/error.h"

namespace terrview {
namespace {

struct OptionField {
  std::string_view field;
  const char* option;
};
constexpr std::array<OptionField, 12> kOptions{{{"heading", "heading"},
                                                {"pitch", "pitch"},
                                                {"roll", "roll"},
                                                {"fov", "fov"},
                                                {"shift", "shift"},
                                                {"size", "size"},
                                                {"projection", "projection"},
                                                {"preset", "preset"},
                                                {"look_at", "look-at"},
                                                {"look-at", "look-at"},
                                                {"sun", "sun"},
                                                {"time", "time"}}};

constexpr std::array<std::string_view, 2> kNames{"name", "id"};

glm::dvec2 place_of(const VectorFeature& feature) {
  const OGRGeometry* geometry = feature.geometry();
  if (geometry == nullptr || wkbFlatten(geometry->getGeometryType()) != wkbPoint ||
      geometry->IsEmpty() != 0)
    feature.refuse("is no point: give points to look from");
  const OGRPoint& point = *geometry->toPoint();
  return {point.getX(), point.getY()};
}

std::optional<double> eye_height_m(const VectorFeature& feature) {
  constexpr std::array<std::string_view, 2> kFields{"eye_height", "height"};
  const auto text = feature.text(kFields);
  if (!text) return std::nullopt;
  const auto height_m = length_of(*text);
  if (!height_m || *height_m < 0)
    feature.refuse("its eye height '" + *text + "' is none: give metres above the ground");
  return height_m;
}

Viewpoint viewpoint_of(const VectorFeature& feature) {
  Viewpoint viewpoint;
  viewpoint.number = feature.number();
  viewpoint.name = feature.line(kNames);
  viewpoint.place = place_of(feature);
  viewpoint.eye_height_m = eye_height_m(feature);
  for (const OptionField& known : kOptions)
    if (const auto text = feature.text(std::span(&known.field, 1)))
      viewpoint.options[known.option] = *text;
  return viewpoint;
}

void make_geographic(ViewpointFile& result, const Dem& dem) {
  std::vector<glm::dvec2> places;
  for (const Viewpoint& viewpoint : result.viewpoints) places.push_back(viewpoint.place);
  VectorFile file = result.file;
  if (file.crs_wkt.empty()) file.crs_wkt = dem.crs_wkt;
  to_geographic(file, places);
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (std::isnan(places[i].x))
      throw InputError("'" + result.file.name + "', feature " + std::to_string(i + 1) +
                       ": is nowhere on the Earth: mend its coordinates or the file's coordinate "
                       "system");
    result.viewpoints[i].place = places[i];
  }
}

}  // namespace

ViewpointFile read_viewpoints(const std::string& path, const Dem& dem) {
  ViewpointFile result;
  result.file = read_vector_file(path, [&](const VectorFeature& feature) {
    result.viewpoints.push_back(viewpoint_of(feature));
  });
  if (result.viewpoints.empty())
    throw InputError("'" + path + "': has no features: give points to look from");
  if (!dem.crs_wkt.empty()) make_geographic(result, dem);
  return result;
}

}  // namespace terrview

#include "ingest/footprints.h"

#include <algorithm>
#include <map>
#include <string_view>

#include <ogr_geometry.h>

#include "ingest/feature_attributes.h"
#include "ingest/feature_polygons.h"
#include "ingest/view_checks.h"

namespace terrview {
namespace {

using Names = std::vector<std::string_view>;

constexpr double kLevel_m = 3;
// The highest building stands 830 m.
constexpr double kHighest_m = 2000;

// Adds to `unread` where that is no length.
std::optional<double> length_in(const VectorFeature& feature, const Names& names, int& unread) {
  const auto text = feature.text(names);
  if (!text) return std::nullopt;
  const auto length_m = length_of(*text);
  unread += length_m ? 0 : 1;
  return length_m;
}

void check_height(const VectorFeature& feature, double height_m) {
  if (height_m > kHighest_m)
    feature.refuse("a height of " + in_words("%g", height_m) + " m: give metres up to " +
                   in_words("%g", kHighest_m));
}

// The first of the heights that the feature has; 0 and less is none.
std::optional<double> height_in(const VectorFeature& feature, const FootprintOptions& options,
                                int& unread) {
  Names names{"height_m", "height", "building:height"};
  if (!options.height_field.empty()) names = {options.height_field};
  for (const std::string_view name : names) {
    const auto text = feature.text(Names{name});
    if (!text) continue;
    const auto height_m = length_of(*text);
    if (!height_m || *height_m <= 0) {
      unread += height_m ? 0 : 1;
      continue;
    }
    check_height(feature, *height_m);
    return height_m;
  }
  const auto levels = length_in(feature, {"building:levels", "levels"}, unread);
  if (!levels || *levels <= 0) return std::nullopt;
  check_height(feature, kLevel_m * *levels);
  return kLevel_m * *levels;
}

std::optional<RoofShape> roof_shape_of(const std::string& text) {
  const std::map<std::string_view, RoofShape> kShapes{
      {"flat", RoofShape::flat},           {"gabled", RoofShape::gabled},
      {"hipped", RoofShape::hipped},       {"half-hipped", RoofShape::hipped},
      {"pyramidal", RoofShape::pyramidal}, {"cone", RoofShape::pyramidal},
      {"skillion", RoofShape::skillion},   {"dome", RoofShape::dome},
      {"onion", RoofShape::dome},          {"gambrel", RoofShape::gabled},
      {"mansard", RoofShape::hipped},      {"round", RoofShape::gabled}};
  const auto found = kShapes.find(text);
  return found == kShapes.end() ? std::nullopt : std::optional(found->second);
}

std::optional<glm::vec3> color_in(const VectorFeature& feature, const Names& names) {
  const auto text = feature.text(names);
  return text ? color_of(*text) : std::nullopt;
}

void read_roof(const VectorFeature& feature, Footprint& footprint, FootprintFile& file) {
  const auto shape = feature.text(Names{"roof:shape"});
  if (shape) {
    const auto known = roof_shape_of(*shape);
    footprint.roof = known.value_or(RoofShape::flat);
    file.unknown_roofs += known ? 0 : 1;
  }
  footprint.roof_height_m = length_in(feature, {"roof:height"}, file.unread_heights);
  const auto azimuth = feature.text(Names{"roof:direction"});
  if (azimuth) footprint.roof_azimuth_deg = azimuth_deg_of(*azimuth);
  footprint.ridge_across = feature.text(Names{"roof:orientation"}) == "across";
  footprint.roof_color = color_in(feature, {"roof:colour", "roof:color"});
}

Footprint footprint_of(const VectorFeature& feature, const FootprintOptions& options,
                       FootprintFile& file) {
  Footprint footprint;
  footprint.number = feature.number();
  footprint.name = feature.text(Names{"name"}).value_or("");
  footprint.height_m = height_in(feature, options, file.unread_heights);
  const auto min_height_m =
      length_in(feature, {"min_height", "building:min_height"}, file.unread_heights);
  const auto min_level = length_in(feature, {"building:min_level"}, file.unread_heights);
  footprint.min_height_m = std::max(0.0, min_height_m.value_or(kLevel_m * min_level.value_or(0)));
  check_height(feature, footprint.min_height_m);
  read_roof(feature, footprint, file);
  const Names colors{"building:colour", "building:color", "colour", "color"};
  footprint.color =
      color_in(feature, options.color_field.empty() ? colors : Names{options.color_field});
  if (footprint.color && !options.color_field.empty()) footprint.roof_color = footprint.color;
  return footprint;
}

}  // namespace

FootprintFile read_footprints(const std::string& path, const FootprintOptions& options) {
  FootprintFile result;
  result.file = read_vector_file(path, [&](const VectorFeature& feature) {
    for (const std::string& field : {options.height_field, options.color_field})
      if (!field.empty()) feature.require_field(field);
    Footprint footprint = footprint_of(feature, options, result);
    footprint.polygons = polygons_of(feature);
    if (footprint.polygons.empty())
      ++result.without_polygon;
    else
      result.footprints.push_back(std::move(footprint));
  });
  return result;
}

TreeFile read_trees(const std::string& path) {
  TreeFile result;
  result.file = read_vector_file(path, [&](const VectorFeature& feature) {
    const OGRGeometry* geometry = feature.geometry();
    if (geometry == nullptr || wkbFlatten(geometry->getGeometryType()) != wkbPoint ||
        geometry->IsEmpty() != 0) {
      ++result.without_point;
      return;
    }
    Tree tree;
    tree.number = feature.number();
    tree.name = feature.text(Names{"name"}).value_or("");
    tree.place = checked_corner(feature, geometry->toPoint()->getX(), geometry->toPoint()->getY());
    tree.height_m = height_in(feature, {}, result.unread_heights);
    tree.crown_m =
        length_in(feature, {"diameter_crown", "crown_m", "crown"}, result.unread_heights);
    tree.trunk_m = length_in(feature, {"circumference"}, result.unread_heights);
    if (tree.trunk_m) check_height(feature, *tree.trunk_m);
    if (tree.crown_m) check_height(feature, *tree.crown_m);
    tree.min_height_m =
        std::max(0.0, length_in(feature, {"min_height"}, result.unread_heights).value_or(0));
    check_height(feature, tree.min_height_m);
    tree.color = color_in(feature, {"colour", "color"});
    result.trees.push_back(std::move(tree));
  });
  return result;
}

}  // namespace terrview

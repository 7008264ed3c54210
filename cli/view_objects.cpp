#include "cli/view_objects.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "cli/add_option.h"
#include "cli/scene/place_scene.h"
#include "ingest/feature_attributes.h"
#include "render/materials/material.h"
#include "render/objects/make_object_set.h"
#include "terrain/error.h"

namespace terrview {
namespace {

const std::map<std::string, BuildingBase>& bases() {
  static const std::map<std::string, BuildingBase> names{
      {"min", BuildingBase::lowest}, {"mean", BuildingBase::mean}, {"max", BuildingBase::highest}};
  return names;
}

std::string counted(int count, const std::string& what) {
  return count > 0 ? ", " + std::to_string(count) + " " + what : "";
}

std::string summary(const VectorFile& file, const PlacedCounts& counts, const std::string& what) {
  return file.name + ": " + std::to_string(counts.features) + " features, " +
         std::to_string(counts.placed) + " " + what + " (" +
         std::to_string(counts.placed - counts.default_height) + " with a height, " +
         std::to_string(counts.default_height) + " without)" +
         counted(counts.without_ground, "beside the ground");
}

void add_warnings(const VectorFile& file, ViewObjects& objects) {
  for (const std::string& warning : file.warnings)
    objects.messages.push_back("warning: " + warning);
}

void check_any(const VectorFile& file, const PlacedCounts& counts, const std::string& wanted) {
  if (counts.features > 0 && counts.without_area == counts.features)
    throw InputError("'" + file.name + "': none of its features is " + wanted);
  if (counts.placed == 0 && counts.without_ground > 0)
    throw InputError("'" + file.name +
                     "': none of its features lies on the ground of the DEM: check its coordinate "
                     "system, or leave it out");
}

void add_buildings(const FootprintFile& file, const ObjectOptions& options, const ViewFrame& frame,
                   ViewObjects& objects) {
  const PlacedCounts counts = place_buildings(file, frame, options.placing, objects.placed);
  check_any(file.file, counts,
            "a polygon with an area: give footprints; points grow trees with --trees");
  objects.messages.push_back(summary(file.file, counts, "buildings") +
                             counted(counts.without_area, "without an area") +
                             counted(counts.upside_down, "no higher than their min_height") +
                             counted(file.unread_heights, "heights or sizes that are no numbers") +
                             counted(file.unknown_roofs, "with an unknown roof, made flat"));
  add_warnings(file.file, objects);
}

void add_trees(const TreeFile& file, const ViewFrame& frame, ViewObjects& objects) {
  const PlacedCounts counts = place_trees(file, frame, objects.placed);
  check_any(file.file, counts, "a point: give points; polygons are raised with --buildings");
  objects.messages.push_back(summary(file.file, counts, "trees") +
                             counted(counts.without_area, "that are no points") +
                             counted(file.unread_heights, "heights or sizes that are no numbers"));
  add_warnings(file.file, objects);
}

// A ray from within an object leaves it first.
void warn_of_eye_within(ViewObjects& objects) {
  if (!objects.scene) return;
  const glm::dvec3 up(0, 0, 1);
  const auto hit = objects.scene->set->first_hit({.origin_m = {0, 0, 0}, .direction = up});
  if (!hit || glm::dot(hit->surface.normal, up) <= 0) return;
  const std::int32_t id = objects.scene->looks[static_cast<std::size_t>(hit->object)].id;
  const auto feature = std::ranges::find(objects.placed.features, id, &PlacedFeature::id);
  objects.messages.push_back("warning: the eye is within " + feature->kind + " " +
                             std::to_string(feature->number) + ": it sees that from inside");
}

// What light goes through casts no shadow.
std::shared_ptr<const SceneObjects> with_casters(std::shared_ptr<const SceneObjects> scene) {
  if (!scene) return scene;
  Objects opaque = opaque_objects(*scene);
  if (opaque.size() == scene->set->objects().size()) return scene;
  auto with = std::make_shared<SceneObjects>(*scene);
  with->casters = make_object_set(std::move(opaque));
  return with;
}

// height, a colour, or the name of a field.
void parse_building_color(const std::string& text, ObjectOptions& options) {
  options.building_color = text;
  if (text == "height")
    options.placing.color_by_height = true;
  else if (const auto color = color_of(text))
    options.placing.color = color;
  else
    options.reading.color_field = text;
}

}  // namespace

void add_object_options(CommandLine& app, ObjectOptions& options) {
  app.add_option("--buildings", options.buildings,
                 "Footprints to raise on the ground: GeoJSON or whatever OGR opens; may be given "
                 "several times")
      ->type_name("FILE")
      ->take_all()
      ->allow_extra_args(false);
  app.add_option("--height", options.reading.height_field,
                 "The field of the buildings' heights, metres (default: height_m, height, "
                 "building:height, or 3 m a level)")
      ->type_name("FIELD");
  add_parsed(
      app, "--default-height",
      [&](const std::string& text) {
        options.placing.default_height_m = parse_number("--default-height", text);
      },
      "Metres, of buildings without a height (default 6)")
      ->type_name("M");
  add_choice<BuildingBase>(app, "--base", options.placing.base, bases(),
                           "The ground under a building that its height is counted from "
                           "(default min)");
  add_parsed(
      app, "--building-color",
      [&](const std::string& text) { parse_building_color(text, options); },
      "R,G,B of all buildings, a field that holds colours, or height")
      ->type_name("COLOR|FIELD|height");
  app.add_option("--trees", options.trees, "Points to grow trees on")->type_name("FILE");
  app.add_option("--objects-csv", options.csv,
                 "How much of each building and tree is seen: pixels, solid angle, share")
      ->type_name("FILE");
}

void check_objects(const ObjectOptions& options, bool has_solids) {
  const double height_m = options.placing.default_height_m;
  if (!(height_m > 0 && height_m <= 2000))
    throw InputError("--default-height: give metres above 0, up to 2000");
  const BuildingOptions unset;
  const bool for_buildings =
      !options.reading.height_field.empty() || !options.building_color.empty() ||
      options.placing.base != unset.base || height_m != unset.default_height_m;
  if (options.buildings.empty() && for_buildings)
    throw InputError(
        "--height, --default-height, --base, --building-color: belong to buildings: give "
        "--buildings too");
  if (!options.csv.empty() && options.buildings.empty() && options.trees.empty() && !has_solids)
    throw InputError("--objects-csv: there are no objects: give --buildings or --trees");
}

const char* name_of(BuildingBase base) {
  for (const auto& [name, value] : bases())
    if (value == base) return name.c_str();
  return "";
}

ViewObjects read_objects(const ViewOptions& options, const ViewFrame& frame, SharedInputs& inputs) {
  const ObjectOptions& files = options.objects;
  ViewObjects objects;
  for (const std::string& buildings : files.buildings)
    add_buildings(*inputs.footprints(buildings, files.reading), files, frame, objects);
  if (!files.trees.empty()) add_trees(*inputs.trees(files.trees), frame, objects);
  if (options.contents) place_solids(*options.contents, frame, objects.placed);
  objects.scene = with_casters(objects.placed.scene_objects());
  warn_of_eye_within(objects);
  return objects;
}

}  // namespace terrview

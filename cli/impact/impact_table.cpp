#include "cli/impact/impact_table.h"

#include <algorithm>
#include <cstdio>

#include "cli/batch/csv.h"

namespace terrview {
namespace {

FieldValue maybe(const std::optional<double>& value) {
  return value ? FieldValue(*value) : FieldValue();
}

FieldValue maybe(const std::string& text) { return text.empty() ? FieldValue() : FieldValue(text); }

void append(std::vector<FieldValue>& row, const std::vector<FieldValue>& more) {
  row.insert(row.end(), more.begin(), more.end());
}

std::vector<FieldValue> point_values(const std::optional<StudyPoint>& point) {
  if (!point) return std::vector<FieldValue>(4);
  return {point->distance_m, point->place.x, point->place.y, point->height_m};
}

std::vector<FieldValue> sight_values(const SightNumbers& numbers) {
  std::vector<FieldValue> values{std::int64_t{numbers.is_seen() ? 1 : 0},
                                 numbers.pixels,
                                 numbers.solid_angle_sr,
                                 numbers.facade.facing_m2,
                                 numbers.facade.seen_m2,
                                 maybe(numbers.facade_share())};
  append(values, point_values(numbers.nearest));
  append(values, point_values(numbers.farthest));
  return values;
}

std::vector<Field> sight_fields(bool geographic) {
  using enum FieldType;
  std::vector<Field> fields{{"seen", integer},        {"pixels", integer},
                            {"solid_angle_sr", real}, {"facade_facing_m2", real},
                            {"facade_seen_m2", real}, {"facade_share", real}};
  for (const std::string end : {"nearest", "farthest"})
    for (const std::string what :
         {"m", geographic ? "longitude" : "x", geographic ? "latitude" : "y", "height_m"})
      fields.push_back({end + "_" + what, real});
  return fields;
}

std::vector<Field> picture_fields() {
  return {{"changed_px", FieldType::integer},
          {"horizon_changed", FieldType::real},
          {"error", FieldType::text}};
}

std::vector<FieldValue> picture_values(const ViewpointStudy& viewpoint) {
  if (!viewpoint.error.empty()) return {{}, {}, viewpoint.error};
  return {viewpoint.changed_px, maybe(viewpoint.horizon_changed), {}};
}

std::vector<FieldValue> building_values(const ProjectBuilding& building) {
  return {std::int64_t{building.number}, maybe(building.name)};
}

}  // namespace

FeatureLayer sights_layer(const ImpactStudy& study) {
  using enum FieldType;
  FeatureLayer layer{.name = "sights",
                     .fields = {{"viewpoint", integer},
                                {"viewpoint_name", text},
                                {"building", integer},
                                {"building_name", text}}};
  const std::vector<Field> fields = sight_fields(study.project.geographic);
  layer.fields.insert(layer.fields.end(), fields.begin(), fields.end());
  for (const Field& field : picture_fields()) layer.fields.push_back(field);
  for (const ViewpointStudy& viewpoint : study.viewpoints) {
    const auto add = [&](const std::vector<FieldValue>& building,
                         const std::vector<FieldValue>& numbers) -> FeatureRow& {
      FeatureRow& row = layer.rows.emplace_back();
      row.values = {std::int64_t{viewpoint.viewpoint.number}, viewpoint.name};
      append(row.values, building);
      append(row.values, numbers);
      return row;
    };
    const bool failed = !viewpoint.error.empty();
    FeatureRow& whole = add({{}, {}}, failed ? std::vector<FieldValue>(fields.size())
                                             : sight_values(viewpoint.project));
    append(whole.values, picture_values(viewpoint));
    for (std::size_t i = 0; i < viewpoint.buildings.size(); ++i) {
      FeatureRow& row =
          add(building_values(study.project.buildings[i]), sight_values(viewpoint.buildings[i]));
      row.values.resize(layer.fields.size());
    }
  }
  return layer;
}

FeatureLayer viewpoints_layer(const ImpactStudy& study) {
  using enum FieldType;
  FeatureLayer layer{.name = "viewpoints",
                     .geometry = FeatureGeometry::point,
                     .crs_wkt = study.crs_wkt,
                     .fields = {{"number", integer}, {"name", text}}};
  const std::vector<Field> eye_fields{{"eye_m", real},
                                      {"ground_m", real},
                                      {"heading_deg", real},
                                      {"pitch_deg", real},
                                      {"fov_deg", real}};
  for (const auto& fields : {eye_fields, sight_fields(study.project.geographic), picture_fields()})
    layer.fields.insert(layer.fields.end(), fields.begin(), fields.end());
  for (const ViewpointStudy& viewpoint : study.viewpoints) {
    FeatureRow& row = layer.rows.emplace_back();
    row.point = viewpoint.viewpoint.place;
    row.values = {std::int64_t{viewpoint.viewpoint.number}, viewpoint.name};
    if (viewpoint.error.empty()) {
      append(row.values,
             {viewpoint.camera.eye.height_m, maybe(viewpoint.ground_m),
              viewpoint.camera.heading_deg, viewpoint.camera.pitch_deg, viewpoint.camera.fov_deg});
      append(row.values, sight_values(viewpoint.project));
    }
    row.values.resize(layer.fields.size() - picture_fields().size());
    append(row.values, picture_values(viewpoint));
  }
  return layer;
}

FeatureLayer buildings_layer(const ImpactStudy& study) {
  using enum FieldType;
  FeatureLayer layer{
      .name = "buildings",
      .geometry = FeatureGeometry::polygons,
      .crs_wkt = study.crs_wkt,
      .fields = {{"number", integer}, {"name", text}, {"height_m", real}, {"seen_from", integer}}};
  for (std::size_t i = 0; i < study.project.buildings.size(); ++i) {
    const ProjectBuilding& building = study.project.buildings[i];
    const auto seen_from = std::ranges::count_if(study.viewpoints, [&](const ViewpointStudy& one) {
      return i < one.buildings.size() && one.buildings[i].is_seen();
    });
    FeatureRow& row = layer.rows.emplace_back();
    row.polygons = building.parts;
    row.values = building_values(building);
    append(row.values, {building.height_m, std::int64_t{seen_from}});
  }
  return layer;
}

std::string csv_text(const FeatureLayer& layer) {
  const auto cell = [](const FieldValue& value) -> std::string {
    if (const auto* whole = std::get_if<std::int64_t>(&value)) return std::to_string(*whole);
    if (const auto* real = std::get_if<double>(&value)) {
      char text[32];
      std::snprintf(text, sizeof text, "%.10g", *real);
      return text;
    }
    if (const auto* text = std::get_if<std::string>(&value)) return csv_cell(*text);
    return "";
  };
  std::string text;
  for (const Field& field : layer.fields) text += (text.empty() ? "" : ",") + field.name;
  text += "\n";
  for (const FeatureRow& row : layer.rows) {
    std::string line;
    for (std::size_t i = 0; i < row.values.size(); ++i)
      line += (i > 0 ? "," : "") + cell(row.values[i]);
    text += line + "\n";
  }
  return text;
}

}  // namespace terrview

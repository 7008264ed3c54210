#include "cli/view_metadata.h"

#include <algorithm>
#include <filesystem>
#include <numbers>

#include <nlohmann/json.hpp>

#include "cli/command_line.h"
#include "cli/scene/scene_contents.h"
#include "cli/view_ground.h"
#include "cli/view_light.h"
#include "cli/view_objects.h"
#include "cli/view_water.h"

namespace terrview {
namespace {

using Json = nlohmann::ordered_json;

std::string file_name(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

// The options that say how the DEMs are read, where they differ from the files' own word.
Json reading_json(const DemOptions& dem) {
  Json json = Json::object();
  if (!dem.crs.empty()) json["a-srs"] = dem.crs;
  if (dem.spacing) json["spacing"] = {dem.spacing->x, dem.spacing->y};
  if (dem.spacing && dem.height_factor) json["spacing"].push_back(*dem.height_factor);
  if (!dem.height_unit.empty()) json["z-unit"] = dem.height_unit;
  if (dem.window) json["window"] = *dem.window;
  if (dem.band != 1) json["band"] = dem.band;
  if (dem.nodata) json["nodata"] = *dem.nodata;
  if (!dem.fill_voids) json["voids"] = "open";
  return json;
}

Json air_json(const AirOptions& options) {
  const Air air = make_air(options);
  const auto color = [](const glm::vec3& c) { return Json{c.x, c.y, c.z}; };
  Json json;
  json["extinction_per_km"] = 1000 * air.extinction_per_m;
  if (air.color) json["color"] = color(*air.color);
  if (air.sunward) json["color_sun"] = color(*air.sunward);
  if (options.haze_px > 0) json["haze"] = options.haze_px;
  return json;
}

Json sky_json(const ViewSkyOptions& sky) {
  if (sky.none) return "none";
  Json json;
  json["model"] = sky.model == SkyModel::gradient ? "gradient" : "preetham";
  json["turbidity"] = sky.turbidity;
  json["seed"] = sky.seed;
  json["clouds"] = sky.clouds;
  if (sky.cloud_base)
    json["cloud_base"] = {{"height_m", sky.cloud_base->height_m},
                          {"above_eye", sky.cloud_base->above_ground}};
  json["cloud_cell_m"] = sky.cloud_cell_m;
  json["cloud_shadows"] = sky.cloud_shadows;
  return json;
}

Json samples_json(const SamplingOptions& options, bool plan) {
  if (plan) return std::max(1, options.samples);
  if (options.preview) return {{"preview", options.contrast}};
  if (options.samples > 0) return options.samples;
  return {{"adaptive", options.contrast}};
}

Json buildings_json(const ObjectOptions& options) {
  Json json;
  for (const std::string& path : options.buildings) json["files"].push_back(file_name(path));
  if (!options.reading.height_field.empty()) json["height"] = options.reading.height_field;
  json["default_height_m"] = options.placing.default_height_m;
  json["base"] = name_of(options.placing.base);
  if (!options.building_color.empty()) json["color"] = options.building_color;
  return json;
}

// What a camera's JSON says of other views.
Json plan_json(const ViewOptions& options, const ResolvedView& view) {
  const Json camera = camera_json(view);
  Json json;
  for (const char* key : {"eye", "size_px", "earth", "z_scale"}) json[key] = camera[key];
  if (options.resolution) json["resolution"] = {options.resolution->x, options.resolution->y};
  return json;
}

Json labels_json(const LabelOptions& options) {
  Json json;
  json["file"] = file_name(options.peaks);
  if (options.size_px) json["size_px"] = *options.size_px;
  if (!options.font.empty()) json["font"] = file_name(options.font);
  return json;
}

Json palette_json(const PaletteOptions& options) {
  Json json;
  if (options.colors) json["colors"] = *options.colors;
  if (!options.use_palette.empty()) json["file"] = file_name(options.use_palette);
  if (options.dither != Dither::none)
    json["dither"] = options.dither == Dither::diffusion ? "diffusion" : "ordered";
  return json;
}

Json natural_json(const NaturalGround& natural) {
  return {{"natural",
           {{"snow_line_m", natural.snow_line_m},
            {"rock_slope_deg", natural.rock_slope_rad * 180 / std::numbers::pi}}}};
}

Json water_json(const WaterOptions& options) {
  Json json;
  if (options.level_m) json["level_m"] = *options.level_m;
  if (!options.file.empty()) json["file"] = file_name(options.file);
  if (options.color) json["color"] = {options.color->x, options.color->y, options.color->z};
  return json;
}

// Of what no option says.
Json contents_json(const SceneContents& contents) {
  Json json = Json::object();
  if (!contents.solids.empty()) json["solids"] = contents.solids.size();
  if (!contents.lamps.empty()) json["lamps"] = contents.lamps.size();
  if (contents.sun || contents.ambient || contents.background) json["light"] = "its own";
  if (contents.display_colors) json["colors"] = "display";
  return json;
}

}  // namespace

std::string view_metadata(const ViewOptions& options, const ResolvedView& view,
                          const SunPosition& sun) {
  constexpr double kDegrees = 180 / std::numbers::pi;
  Json json;
  json["program"] = std::string("terrview ") + kVersion;
  if (view.plan)
    json["plan"] = plan_json(options, view);
  else
    json["camera"] = camera_json(view);
  if (options.dpi) json["dpi"] = *options.dpi;
  json["dems"] = Json::array();
  for (const std::string& dem : options.dems) json["dems"].push_back(file_name(dem));
  const Json reading = reading_json(options.dem);
  if (!reading.empty()) json["reading"] = reading;
  json["sun"] = {{"azimuth", sun.azimuth_rad * kDegrees},
                 {"elevation", sun.elevation_rad * kDegrees}};
  const LightOptions& light = options.light;
  json["sun"]["refracted"] = light.refracted_sun;
  json["shade"] = light.relief ? "relief" : "sun";
  json["shadows"] = !casts_shadows(light) ? "none" : light.soft_shadows ? "soft" : "hard";
  json["sky_view"] = light.sky_azimuths;
  if (!view.plan) json["air"] = air_json(options.air);
  json["sky"] = sky_json(options.sky);
  if (!options.objects.buildings.empty()) json["buildings"] = buildings_json(options.objects);
  if (!options.objects.trees.empty()) json["trees"] = file_name(options.objects.trees);
  if (!options.labels.peaks.empty()) json["peaks"] = labels_json(options.labels);
  json["samples"] = samples_json(options.sampling, view.plan);
  json["lod"] = options.sampling.detail;
  json["surface"] = name_of(options.surface);
  if (options.coherence == Coherence::neighbours) json["coherence"] = "neighbours";
  json["normals"] = options.normals == NormalKind::facet ? "facet" : "smooth";
  if (const auto natural = natural_ground(options))
    json["colors"] = natural_json(*natural);
  else if (!options.colors.empty())
    json["colors"] = file_name(options.colors);
  if (!options.drape.empty()) json["drape"] = file_name(options.drape);
  if (options.contour_interval_m > 0) json["contours"] = options.contour_interval_m;
  if (has_water(options.water)) json["water"] = water_json(options.water);
  if (options.contents) {
    const Json scene = contents_json(*options.contents);
    if (!scene.empty()) json["scene"] = scene;
  }
  if (wants_palette(options.palette)) json["palette"] = palette_json(options.palette);
  // File names may be no UTF-8.
  return json.dump(-1, ' ', true, Json::error_handler_t::replace);
}

}  // namespace terrview

#include "cli/view_water.h"

#include <charconv>
#include <cmath>

#include "cli/add_option.h"
#include "ingest/view_checks.h"
#include "terrain/error.h"

namespace terrview {
namespace {

std::optional<double> number_of(const std::string& text) {
  double number = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || rest != end) return std::nullopt;
  return number;
}

// A level or a file.
void take_water(const std::string& text, WaterOptions& options) {
  const auto level_m = number_of(text);
  if (level_m && !(std::abs(*level_m) < kHighest_m))
    throw InputError("--water " + text + ": give metres in the DEM's heights");
  if (level_m ? options.level_m.has_value() : !options.file.empty())
    throw InputError("--water " + text + ": the second " + (level_m ? "level" : "file") +
                     ": give one of each at most");
  if (level_m)
    options.level_m = level_m;
  else
    options.file = text;
}

void check_eye(const Scene& scene, double level_m) {
  const VerticalFrame& frame = scene.terrain->frame();
  const auto ground = scene.terrain->ground_at({0, 0});
  if (!ground || ground->scene_height_m > level_m || frame.eye_height_m > level_m) return;
  throw InputError("--water: the eye is " +
                   in_words("%.3f", (level_m - frame.eye_height_m) / frame.z_scale) +
                   " m under the water: raise it, or give a lower level");
}

// Of each layer of the terrain, by its grid.
std::vector<std::shared_ptr<const Lakes>> lakes_of(const Terrain& terrain,
                                                   const FloodedDems& flooded) {
  std::vector<std::shared_ptr<const Lakes>> lakes;
  for (const TerrainLayer& layer : terrain.layers()) {
    lakes.emplace_back();
    for (std::size_t i = 0; i < flooded.dems.size(); ++i)
      if (flooded.dems[i].grid == layer.grid) lakes.back() = flooded.lakes[i];
  }
  return lakes;
}

}  // namespace

void add_water_options(CommandLine& app, WaterOptions& options) {
  app.add_option_function<std::vector<std::string>>(
         "--water",
         [&options](const std::vector<std::string>& texts) {
           options.level_m.reset();
           options.file.clear();
           for (const std::string& text : texts) take_water(text, options);
         },
         "Water over ground at a height or below, or in the polygons of a file; may be given for "
         "both")
      ->expected(1)
      ->allow_extra_args(false)
      ->take_all()
      ->type_name("LEVEL|FILE");
  add_parsed(
      app, "--water-color",
      [&options](const std::string& text) { options.color = parse_color("--water-color", text); },
      "Of what is seen below the surface, sRGB 0-255 (default 34,70,78)")
      ->type_name("R,G,B");
}

bool has_water(const WaterOptions& options) { return options.level_m || !options.file.empty(); }

void check_water(const WaterOptions& options) {
  if (options.color && !has_water(options))
    throw InputError("--water-color: there is no water: give --water LEVEL or FILE");
}

LaidWater lay_water(const WaterOptions& options, const std::vector<Dem>& dems) {
  LaidWater laid;
  if (options.file.empty()) return laid;
  const WaterBodies water = read_water(options.file);
  laid.lakes = flood(dems, water);
  const int beside = static_cast<int>(water.bodies.size()) - laid.lakes->placed;
  std::string line = water.file.name + ": " + std::to_string(water.file.features) + " features, " +
                     std::to_string(laid.lakes->placed) + " waters (" +
                     std::to_string(laid.lakes->from_shore) + " at the level of their shore)";
  if (beside > 0) line += ", " + std::to_string(beside) + " beside the ground";
  if (water.without_area > 0)
    line += ", " + std::to_string(water.without_area) + " without an area";
  laid.messages.push_back(std::move(line));
  for (const std::string& warning : water.file.warnings)
    laid.messages.push_back("warning: " + warning);
  return laid;
}

std::shared_ptr<const Water> make_water(const WaterOptions& options, const LaidWater& laid,
                                        const Scene& scene, bool mirrors,
                                        const std::shared_ptr<const PaintedSky>& mirrored_sky) {
  Water water;
  water.color = options.color.value_or(water.color);
  if (laid.lakes) water.lakes = lakes_of(*scene.terrain, *laid.lakes);
  if (options.level_m) {
    water.level_m = scene.terrain->frame().z_scale * *options.level_m;
    if (mirrors) check_eye(scene, *water.level_m);
  }
  std::shared_ptr<Scene> reflected;
  if (mirrors) {
    reflected = std::make_shared<Scene>(scene);
    reflected->painted_sky = mirrored_sky;
    reflected->water = std::make_shared<const Water>(water);
  }
  water.reflected = std::move(reflected);
  return std::make_shared<const Water>(std::move(water));
}

}  // namespace terrview

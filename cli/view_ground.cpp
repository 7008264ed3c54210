#include "cli/view_ground.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "cli/add_option.h"
#include "ingest/color_ramp_file.h"
#include "render/named_ramps.h"
#include "terrain/error.h"

namespace terrview {
namespace {

constexpr double kRadians = std::numbers::pi / 180;
constexpr const char* kNatural = "natural";

void add_natural_options(CommandLine& app, NaturalOptions& natural) {
  add_number(app, "--snow-line", natural.snow_line_m,
             "Of natural colours: metres above which level ground is white (default 2800)")
      ->type_name("M");
  add_number(app, "--rock-slope", natural.rock_slope_deg,
             "Of natural colours: degrees from which ground is rock (default 35)")
      ->type_name("D");
}

HeightRange whole_range(const Terrain& terrain) {
  HeightRange whole = height_range(*terrain.layers().front().grid);
  for (const TerrainLayer& layer : terrain.layers()) {
    const HeightRange range = height_range(*layer.grid);
    whole.lowest_m = std::min(whole.lowest_m, range.lowest_m);
    whole.highest_m = std::max(whole.highest_m, range.highest_m);
  }
  return whole;
}

// A grid that goes around the Earth may have two layers.
std::vector<Dem> dem_of_each_layer(const Terrain& terrain, const std::vector<Dem>& dems) {
  std::vector<Dem> of_layers;
  for (const TerrainLayer& layer : terrain.layers())
    of_layers.push_back(*std::find_if(dems.begin(), dems.end(),
                                      [&](const Dem& dem) { return dem.grid == layer.grid; }));
  return of_layers;
}

}  // namespace

void add_ground_color_options(CommandLine& app, ViewOptions& options) {
  app.add_option("--colors", options.colors,
                 "Colours by altitude: gdaldem color-relief text or a QGIS colour map, or their "
                 "name; natural: by slope and altitude")
      ->type_name("alpine|arid|polar|grey|natural|FILE");
  add_natural_options(app, options.natural);
  app.add_option("--drape", options.drape,
                 "A georeferenced picture over the ground: anything GDAL opens with 8 or 16 bits")
      ->type_name("IMAGE");
  add_parsed(
      app, "--contours",
      [&](const std::string& text) {
        options.contour_interval_m = parse_number("--contours", text);
        if (!(options.contour_interval_m >= 0.01 && options.contour_interval_m <= 100'000))
          throw InputError("--contours: give metres between lines, from 0.01 to 100000");
      },
      "Contour lines, so many metres of height apart")
      ->type_name("M");
}

void check_ground_colors(const ViewOptions& options) {
  const NaturalOptions& natural = options.natural;
  if (options.colors != kNatural && (natural.snow_line_m || natural.rock_slope_deg))
    throw InputError("--snow-line, --rock-slope: belong to natural colours: give --colors natural");
  if (natural.rock_slope_deg && !(*natural.rock_slope_deg > 0 && *natural.rock_slope_deg < 90))
    throw InputError("--rock-slope: give degrees between 0 and 90");
  std::error_code unreadable_then;
  if (has_ramp_file(options) && !std::filesystem::exists(options.colors, unreadable_then))
    throw InputError("--colors '" + options.colors +
                     "': is neither a file nor the name of colours: check it");
}

bool has_ramp_file(const ViewOptions& options) {
  return !options.colors.empty() && options.colors != kNatural &&
         find_named_ramp(options.colors) == nullptr;
}

std::optional<NaturalGround> natural_ground(const ViewOptions& options) {
  if (options.colors != kNatural) return std::nullopt;
  NaturalGround ground;
  ground.snow_line_m = options.natural.snow_line_m.value_or(ground.snow_line_m);
  if (options.natural.rock_slope_deg)
    ground.rock_slope_rad = *options.natural.rock_slope_deg * kRadians;
  return ground;
}

void set_ground_colors(const ViewOptions& options, const std::vector<Dem>& dems,
                       SharedInputs& inputs, Scene& scene) {
  scene.natural = natural_ground(options);
  if (const ColorRamp* named = find_named_ramp(options.colors))
    scene.tints = *named;
  else if (has_ramp_file(options))
    scene.tints = read_color_ramp(options.colors, whole_range(*scene.terrain));
  scene.contours.interval_m = options.contour_interval_m;
  if (!options.drape.empty())
    scene.drape = inputs.drape(options.drape, dem_of_each_layer(*scene.terrain, dems),
                               options.dem.memory_bytes);
}

}  // namespace terrview

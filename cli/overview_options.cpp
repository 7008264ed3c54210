#include "cli/overview_options.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "cli/add_option.h"
#include "cli/command_line.h"
#include "cli/output_options.h"
#include "cli/prepare_view.h"
#include "cli/view_ground.h"
#include "cli/view_light_options.h"
#include "ingest/feature_attributes.h"
#include "terrain/error.h"

namespace terrview {
namespace {

constexpr double kRadians = std::numbers::pi / 180;
// Of a map: from the upper left, and low enough to cast shadows that tell.
constexpr SunPosition kMapSun{315 * kRadians, 40 * kRadians};
constexpr int kSkyAzimuths = 32;
// Of a block: from behind the eye on the left, so that the walls it sees are lit.
constexpr double kBlockSun_deg = 40;
constexpr double kBlockSunHeight_deg = 35;
constexpr double kFlattest_deg = 5;

double parse_side(const std::string& text) {
  const auto side = azimuth_deg_of(text);
  if (!side || !std::isfinite(*side))
    throw InputError("--from: '" + text +
                     "': give a point of the compass, as s or wsw, or degrees clockwise from "
                     "north");
  return *side;
}

void add_block_options(CommandLine& app, OverviewOptions& options) {
  add_parsed(
      app, "--from", [&](const std::string& text) { options.from_deg = parse_side(text); },
      "The side that the block is seen from: s, wsw, ... or degrees (default s)")
      ->type_name("SIDE");
  add_parsed(
      app, "--tilt",
      [&](const std::string& text) { options.tilt_deg = parse_number("--tilt", text); },
      "Degrees that the view looks down, 5 to 90 (default 35)")
      ->type_name("D");
  add_parsed(
      app, "--size", [&](const std::string& text) { options.view.size_px = parse_size(text); },
      "Pixels (default: 1600 wide, as high as the block needs)")
      ->type_name("WxH");
  add_choice<TickSystem>(app, "--ticks", options.ticks,
                         {{"own", TickSystem::own}, {"degrees", TickSystem::degrees}},
                         "Coordinates of the first DEM's own system (default) or WGS 84");
  app.add_option("--title", options.title, "Above the block (default: the DEMs' names)");
  app.add_option("--font", options.view.labels.font, "A TrueType or OpenType file")
      ->type_name("FILE");
  app.add_flag("--plain", options.plain, "The block alone: no title, ticks, arrow and scale");
  app.add_option("--samples", options.view.sampling.samples,
                 "Rays a pixel (default: adaptive; of a map 1)")
      ->between(1, 1024);
}

void add_map_options(CommandLine& app, OverviewOptions& options) {
  app.add_flag("--plan", options.plan, "A georeferenced map instead: shading, shadows, sky view");
  add_parsed(
      app, "--resolution",
      [&](const std::string& text) {
        const auto steps = parse_numbers("--resolution", text, 1, 2);
        options.view.resolution = glm::dvec2(steps.front(), steps.back());
      },
      "Of a map: the size of a pixel in the DEM's units (default: a post)")
      ->type_name("DX[,DY]");
  auto* tiles =
      add_parsed(
          app, "--tiles", [&](const std::string& text) { options.tiles = parse_size(text); },
          "A map in so many sheets")
          ->type_name("CxR");
  auto* size = add_parsed(
                   app, "--tile-size",
                   [&](const std::string& text) { options.tile_size_px = parse_size(text); },
                   "A map in sheets of so many pixels")
                   ->type_name("WxH");
  auto* sheets = app.add_option("--sheets", options.sheets,
                                "A map in the sheets whose outlines are the features of a file")
                     ->type_name("FILE");
  app.add_option("--sheet-name", options.sheet_name, "Their field with a name (default name)")
      ->type_name("FIELD")
      ->needs(sheets);
  tiles->excludes(size)->excludes(sheets);
  size->excludes(sheets);
}

void add_file_options(CommandLine& app, ViewOptions& view) {
  app.add_option("-o", view.output,
                 "Picture or map (default: the first DEM's name; of sheets NAME_{name}.tif)")
      ->type_name("FILE");
  add_format_options(app, view.format, view.creation, "GDAL's own of a map");
  app.add_flag("--overwrite", view.overwrite, "Replace existing outputs");
  app.add_option("--threads", view.threads, "Never changes the picture (default: all)")
      ->between(1, 256);
  add_bar_options(app, view.quiet, view.progress);
}

// Options that were given for the other kind of overview.
void check_kind(const CommandLine& app, bool plan) {
  constexpr std::array kOfBlocks{"--from",  "--tilt", "--size", "--ticks",
                                 "--title", "--font", "--plain"};
  const auto refuse = [&](const char* name, const std::string& how) {
    if (app.count(name) > 0) throw InputError(std::string(name) + ": " + how);
  };
  if (plan)
    for (const char* name : kOfBlocks) refuse(name, "belongs to a block: leave it out of a map");
  else
    refuse("--resolution", "of a map: add --plan, or give --size");
  if (app.count("--plain") > 0)
    for (const char* name : {"--ticks", "--title", "--font"})
      refuse(name, "is not in a --plain picture: leave out one of them");
}

void check_sheets(const OverviewOptions& options) {
  for (const auto& size : {options.tiles, options.tile_size_px})
    if (size && (size->x < 1 || size->y < 1))
      throw InputError("--tiles, --tile-size: give numbers from 1");
}

void set_defaults(OverviewOptions& options) {
  ViewOptions& view = options.view;
  view.plan = options.plan;
  view.plan_alpha = options.in_sheets();
  LightOptions& light = view.light;
  const bool open = !light.sun && !light.time && !light.relief;
  if (options.plan) {
    if (open) light.sun = kMapSun;
    if (light.sky_azimuths == 0) light.sky_azimuths = kSkyAzimuths;
    return;
  }
  if (open)
    light.sun =
        SunPosition{(options.from_deg + kBlockSun_deg) * kRadians, kBlockSunHeight_deg * kRadians};
  view.earth = EarthModel::flat;
  view.sky.none = true;
  view.air.visibility_km = std::numeric_limits<double>::infinity();
}

}  // namespace

OverviewOptions parse_overview(const std::vector<std::string>& args) {
  OverviewOptions options;
  CommandLine app("A whole region: a block seen from a side, a map, or sheets of one",
                  "terrview overview");
  add_dem_options(app, options.view.dems, options.view.dem);
  add_block_options(app, options);
  add_map_options(app, options);
  add_number(app, "--z-scale", options.view.z_scale,
             "Multiply heights (default: by the relief; of a map 1)");
  add_light_options(app, options.view);
  add_ground_color_options(app, options.view);
  add_file_options(app, options.view);
  app.parse_args(args);
  if (options.in_sheets()) options.plan = true;
  check_kind(app, options.plan);
  check_sheets(options);
  if (!(options.tilt_deg >= kFlattest_deg && options.tilt_deg <= 90))
    throw InputError("--tilt: give degrees from 5, nearly level, to 90, straight down");
  set_defaults(options);
  return options;
}

}  // namespace terrview

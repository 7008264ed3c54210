#include "cli/view_options.h"

#include "cli/add_option.h"
#include "cli/output_options.h"
#include "cli/preset.h"
#include "cli/view_ground.h"
#include "cli/view_labels.h"
#include "cli/view_light_options.h"
#include "cli/view_objects.h"
#include "cli/view_sky.h"
#include "cli/view_water.h"
#include "cli/view_wireline.h"

namespace terrview {
namespace {

void add_place_options(CommandLine& app, ViewOptions& options) {
  auto* eye = add_parsed(
                  app, "--eye", [&](const std::string& text) { options.eye = parse_eye(text); },
                  "Where the eye is: degrees (WGS 84) and metres; +H is above the ground there")
                  ->type_name("LAT,LON,ALT");
  auto* eye_xy =
      add_parsed(
          app, "--eye-xy", [&](const std::string& text) { options.eye = parse_eye_xy(text); },
          "The same in the first DEM's own coordinates")
          ->type_name("X,Y,Z");
  auto* look_at =
      add_parsed(
          app, "--look-at", [&](const std::string& text) { options.look_at = parse_look_at(text); },
          "Aim at a point (default: the DEM's centre)")
          ->type_name("LAT,LON[,ALT]");
  auto* look_at_xy = add_parsed(
                         app, "--look-at-xy",
                         [&](const std::string& text) { options.look_at = parse_look_at_xy(text); },
                         "The same in the first DEM's own coordinates")
                         ->type_name("X,Y[,Z]");
  auto* heading = add_number(app, "--heading", options.heading_deg,
                             "Degrees clockwise from true north; alone, pitch is 0");
  eye->excludes(eye_xy);
  look_at->excludes(look_at_xy)->excludes(heading);
  look_at_xy->excludes(heading);
  add_number(app, "--pitch", options.pitch_deg, "Degrees up");
  add_number(app, "--roll", options.roll_deg, "Degrees clockwise as seen from behind the camera");
  app.add_option("--from-camera", options.from_camera, "Make the view of a --camera file again")
      ->type_name("FILE");
}

void add_projection_options(CommandLine& app, ViewOptions& options) {
  add_number(app, "--fov", options.fov_deg, "Horizontal field of view, degrees (default 60)");
  add_parsed(
      app, "--size", [&](const std::string& text) { options.size_px = parse_size(text); },
      "Pixels (default 1280x720)")
      ->type_name("WxH");
  app.add_option_function<std::string>(
         "--projection",
         [&](const std::string& text) {
           options.plan = text == "plan";
           if (options.plan) return;
           options.projection = text == "perspective"   ? Projection::perspective
                                : text == "cylindrical" ? Projection::cylindrical
                                                        : Projection::orthographic;
         },
         "How the view falls on the picture (default perspective)")
      ->one_of({"perspective", "cylindrical", "orthographic", "plan"})
      ->type_name("perspective|cylindrical|orthographic|plan");
  add_parsed(
      app, "--resolution",
      [&](const std::string& text) {
        const auto steps = parse_numbers("--resolution", text, 1, 2);
        options.resolution = glm::dvec2(steps.front(), steps.back());
      },
      "Of a plan: the size of a pixel in the DEM's units (default: a post)")
      ->type_name("DX[,DY]");
  add_number(app, "--width", options.width_m, "Metres across an orthographic picture");
  add_parsed(
      app, "--shift", [&](const std::string& text) { options.shift = parse_shift(text); },
      "Of the lens, right and up, in widths and heights of the picture: uprights stay upright")
      ->type_name("X,Y");
  add_parsed(
      app, "--crop", [&](const std::string& text) { options.crop = parse_crop(text); },
      "Only these pixels of the picture, as they are in the whole")
      ->type_name("X,Y,W,H");
  add_preset_options(app, options);
}

void add_ground_options(CommandLine& app, ViewOptions& options) {
  add_number(app, "--z-scale", options.z_scale, "Multiply heights and an absolute ALT (default 1)");
  std::map<std::string, SurfaceModel> surfaces;
  for (const SurfaceModel model : kSurfaceModels) surfaces[name_of(model)] = model;
  add_choice(app, "--surface", options.surface, surfaces,
             "The ground between posts (default hyperboloid)");
  app.add_option_function<std::string>(
         "--earth",
         [&](const std::string& text) {
           options.earth = text == "flat" ? EarthModel::flat : EarthModel::curved;
         },
         "curved (default), or flat: the affine map at the eye, no drop")
      ->one_of({"curved", "flat"})
      ->type_name("curved|flat");
  add_choice<Coherence>(
      app, "--coherence", options.coherence,
      {{"on", Coherence::on}, {"off", Coherence::off}, {"neighbours", Coherence::neighbours}},
      "off: trace every ray on its own, cell by cell; the same picture, later. neighbours: begin "
      "each where its neighbours hit, which may miss thin peaks; for study");
  add_number(app, "--refraction", options.refraction, "Geodetic coefficient k (default 0.13)");
}

void add_output_options(CommandLine& app, ViewOptions& options) {
  app.add_option("-o", options.output,
                 "Picture: png, jpg, tif, exr, webp or ppm (default: the first DEM's name + .png)")
      ->type_name("FILE");
  add_format_options(app, options.format, options.creation, "QUALITY, ZLEVEL or COMPRESS");
  app.add_flag("--overwrite", options.overwrite, "Replace existing outputs");
  add_palette_options(app, "--palette", options.palette);
  app.add_option("--layers", options.layers,
                 "Per-pixel distance, place, height and object, as .tif or .exr")
      ->type_name("FILE");
  app.add_option("--stats", options.stats, "What the work cost, and its errors, as JSON")
      ->type_name("FILE");
  app.add_option("--camera", options.camera, "The resolved camera as JSON")->type_name("FILE");
  app.add_option("--threads", options.threads, "Never changes the picture (default: all)")
      ->between(1, 256);
  add_bar_options(app, options.quiet, options.progress);
}

}  // namespace

void add_dem_options(CommandLine& app, std::vector<std::string>& dems, DemOptions& options) {
  app.add_option("DEM", dems, "Elevation models in order of preference: anything GDAL opens")
      ->required()
      ->type_name("FILE");
  app.add_option("--a-srs", options.crs, "The DEMs' coordinate reference system, as EPSG:4326")
      ->type_name("CRS");
  add_parsed(
      app, "--spacing",
      [&](const std::string& text) {
        const auto steps = parse_numbers("--spacing", text, 2, 3);
        options.spacing = glm::dvec2(steps[0], steps[1]);
        if (steps.size() == 3) options.height_factor = steps[2];
      },
      "Metres between posts (and per unit of height) of a grid without a place")
      ->type_name("DX,DY[,DZ]");
  app.add_option("--z-unit", options.height_unit, "Unit of the heights: m, ft, us-ft, cm, ...")
      ->type_name("UNIT");
  add_parsed(
      app, "--window", [&](const std::string& text) { options.window = parse_window(text); },
      "Read only this window, in posts")
      ->type_name("COL,ROW,W,H");
  app.add_option("-b,--band", options.band, "Band of the heights (default 1)");
  app.add_option("--nodata", options.nodata, "The value that means no data");
  app.add_option_function<double>(
         "--memory",
         [&](double mebibytes) {
           options.memory_bytes = static_cast<std::size_t>(mebibytes * (1 << 20));
         },
         "Refuse DEMs that need more than this (default: half of the machine's)")
      ->between(1.0, 1e9)
      ->type_name("MIB");
  app.add_option_function<std::string>(
         "--voids", [&](const std::string& text) { options.fill_voids = text == "fill"; },
         "Fill interior voids up to 32 posts across (default), or leave all open")
      ->one_of({"fill", "open"})
      ->type_name("fill|open");
}

void add_view_options(CommandLine& app, ViewOptions& options) {
  add_dem_options(app, options.dems, options.dem);
  add_place_options(app, options);
  add_projection_options(app, options);
  add_ground_options(app, options);
  add_light_options(app, options);
  add_ground_color_options(app, options);
  add_water_options(app, options.water);
  add_air_options(app, options.air);
  add_view_sky_options(app, options.sky);
  add_object_options(app, options.objects);
  add_label_options(app, options.labels);
  add_wireline_options(app, options.wireline);
  add_sampling_options(app, options);
  add_output_options(app, options);
}

}  // namespace terrview

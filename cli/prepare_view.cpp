#include "cli/prepare_view.h"

#include <cmath>
#include <string>

#include "cli/camera_json.h"
#include "cli/command_line.h"
#include "cli/plan.h"
#include "cli/preset.h"
#include "cli/scene/scene_contents.h"
#include "cli/view_ground.h"
#include "cli/view_labels.h"
#include "cli/view_light.h"
#include "cli/view_objects.h"
#include "cli/view_setup.h"
#include "cli/view_water.h"
#include "cli/view_wireline.h"
#include "terrain/error.h"

namespace terrview {
namespace {

constexpr const char* kAbout = "What can be seen of the ground from a point on the Earth";

void add_print_scene(CommandLine& app, bool& prints_scene) {
  app.add_flag("--print-scene", prints_scene,
               "Write the view as a scene file to standard output instead");
}

void check_angles(const ViewOptions& options) {
  if (std::abs(options.pitch_deg.value_or(0)) > 90)
    throw InputError("--pitch: give degrees between -90 (down) and 90 (up)");
}

void check_earth(const ViewOptions& options) {
  if (options.earth == EarthModel::flat && options.refraction)
    throw InputError("--refraction: light is straight over a flat Earth: leave it out");
  if (options.refraction && std::abs(*options.refraction) > 1)
    throw InputError("--refraction: k lies between -1 and 1 (0.13 by day)");
  check_z_scale(options);
}

void check_eye(const EyePlace& eye) {
  // Beyond this the Earth is a point, and the view frame's numbers lose their digits.
  constexpr double kFarthest_m = 1e8;
  const auto far = [&](double value_m) { return std::abs(value_m) > kFarthest_m; };
  if (far(eye.height_m) || (eye.projected && (far(eye.projected->x) || far(eye.projected->y))))
    throw InputError((eye.geographic ? "--eye" : "--eye-xy") +
                     std::string(": further than 100 000 km: give metres near the DEM"));
}

// Options of one projection given for another.
void check_projection(const ViewOptions& given, const ResolvedView& known) {
  const bool orthographic = known.projection == Projection::orthographic;
  if (given.width_m && !orthographic)
    throw InputError(
        "--width: the width of an orthographic picture: add --projection orthographic, or give "
        "--fov");
  if (given.fov_deg && orthographic)
    throw InputError("--fov: an orthographic view has parallel rays: give --width METRES instead");
  if (given.coherence == Coherence::neighbours && known.crop)
    throw InputError("--coherence neighbours: goes on from row to row: leave it out for a --crop");
  if (given.coherence == Coherence::neighbours && orthographic)
    throw InputError("--coherence neighbours: needs an eye: leave it out for an orthographic view");
}

void check_sampling(const ViewOptions& options) {
  if (!(options.sampling.contrast >= 0 && options.sampling.contrast <= 1))
    throw InputError("--aa: give a difference in sRGB from 0 to 1, as 0.03");
  if (options.sampling.preview && !options.layers.empty())
    throw InputError("--layers: a preview does not trace every pixel: leave out --preview");
  if (options.sampling.preview && !options.objects.csv.empty())
    throw InputError("--objects-csv: a preview does not trace every pixel: leave out --preview");
}

void check_palette(const ViewOptions& options) {
  const PaletteOptions& palette = options.palette;
  check_palette_options(palette);
  if (!wants_palette(palette) && (palette.dither != Dither::none || !palette.save_palette.empty()))
    throw InputError("--dither, --save-palette: belong to a palette: give --palette too");
  if (wants_palette(palette) && !options.progressive.empty())
    throw InputError("--progressive " + options.progressive +
                     ": is not written with a palette: leave out one of them");
}

// Of a view without a DEM.
void check_without_ground(const ViewOptions& options) {
  const WaterOptions& water = options.water;
  const char* needy = options.plan                                     ? "--projection plan"
                      : !options.drape.empty()                         ? "--drape"
                      : !options.colors.empty()                        ? "--colors"
                      : water.level_m || !water.file.empty()           ? "--water"
                      : !options.labels.peaks.empty()                  ? "--peaks"
                      : !options.wireline.file.empty()                 ? "--wireline"
                      : options.light.sky_azimuths > 0                 ? "--sky-view"
                      : options.earth == EarthModel::curved            ? "--earth curved"
                      : options.refraction                             ? "--refraction"
                      : options.look_at && options.look_at->geographic ? "--look-at"
                                                                       : nullptr;
  if (needy != nullptr)
    throw InputError(std::string(needy) + ": there is no ground: name a DEM, or leave it out");
}

}  // namespace

void check_z_scale(const ViewOptions& options) {
  if (options.z_scale && !(*options.z_scale > 0 && *options.z_scale <= 1000))
    throw InputError("--z-scale: give a number above 0, up to 1000");
}

void prepare(ViewOptions& options) {
  apply_preset(options);
  const ViewOptions given = options;
  if (!options.from_camera.empty()) apply_camera_file(options);
  if (options.dems.empty()) check_without_ground(options);
  check_plan(options);
  if (!options.eye && !options.plan)
    throw InputError("--eye: missing: say where the eye is, as --eye 47.9,7.1,+2");
  if (options.eye) check_eye(*options.eye);
  if (options.dems.empty() && !options.look_at && !options.heading_deg)
    throw InputError("--heading: missing: without a DEM nothing else says where to look");
  check_angles(options);
  check_earth(options);
  check_light(options.light);
  check_air(options.air);
  check_sampling(options);
  check_palette(options);
  check_objects(options.objects, options.contents && !options.contents->solids.empty());
  check_ground_colors(options);
  check_water(options.water);
  check_labels(options.labels);
  if (options.crop && !options.labels.peaks.empty())
    throw InputError("--crop: names find their room in a whole picture: leave out --peaks");
  check_wireline(options.wireline);
  const ResolvedView known = known_view(options);
  check_projection(given, known);
  static_cast<void>(make_camera(known));  // throws if there is no such camera
  // A lens is shifted so that the camera may stay level.
  const bool shifted = known.shift != glm::dvec2(0) && !options.pitch_deg;
  if (options.projection == Projection::cylindrical || shifted) options.pitch_deg = 0;
}

GivenView given_view(const std::vector<std::string>& args, const std::string& program) {
  ViewOptions options;
  CommandLine app(kAbout, program);
  add_view_options(app, options);
  GivenView given;
  add_print_scene(app, given.prints_scene);
  app.get_option("DEM")->required(false);
  app.parse_args(args);
  given.values = ViewVocabulary().given(app);
  given.dems = std::move(options.dems);
  return given;
}

ViewOptions parse_view(const std::vector<std::string>& args, const std::string& program,
                       std::shared_ptr<const SceneContents> contents) {
  ViewOptions options;
  CommandLine app(kAbout, program);
  add_view_options(app, options);
  if (contents) app.get_option("DEM")->required(false);
  options.contents = std::move(contents);
  add_print_scene(app, options.prints_scene);
  app.parse_args(args);
  prepare(options);
  return options;
}

}  // namespace terrview

#include "cli/view_light_options.h"

#include <numbers>

#include "cli/add_option.h"

namespace terrview {
namespace {

constexpr double kRadians = std::numbers::pi / 180;

void add_sun_options(CLI::App& app, LightOptions& light) {
  auto* sun = add_parsed(
                  app, "--sun",
                  [&light](const std::string& text) {
                    const auto angles = parse_numbers("--sun", text, 2, 2);
                    light.sun = SunPosition{angles[0] * kRadians, angles[1] * kRadians};
                  },
                  "The sun as seen from the eye, degrees (default: 3 pm on the longest day there)")
                  ->type_name("AZ,EL");
  auto* time =
      add_parsed(
          app, "--time", [&light](const std::string& text) { light.time = parse_time(text); },
          "The sun at a date, as 2026-06-21T15:00Z or with an offset as +02:00")
          ->type_name("DATE");
  add_switch(app, "--sun-refraction", light.refracted_sun,
             "on: the air lifts the sun of --sun or --time (default off)");
  app.add_flag("--no-shadows", light.no_shadows, "No cast shadows");
  app.add_flag("--soft-shadows", light.soft_shadows,
               "Shadows have the soft edge of the sun's disc");
  auto* shade =
      add_choice<bool>(app, "--shade", light.relief, {{"sun", false}, {"relief", true}},
                       "relief: a map's light, from the north-west, without cast shadows");
  time->excludes(sun)->excludes(shade);
}

}  // namespace

void add_light_options(CLI::App& app, ViewOptions& options) {
  add_sun_options(app, options.light);
  add_choice<NormalKind>(app, "--normals", options.normals,
                         {{"smooth", NormalKind::smooth}, {"facet", NormalKind::facet}},
                         "Light smooth ground (default) or its facets");
  app.add_option("--colors", options.colors,
                 "Colours by altitude: gdaldem color-relief text or a QGIS colour map")
      ->type_name("FILE");
}

}  // namespace terrview

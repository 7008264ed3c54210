#include "cli/view_light_options.h"

#include <numbers>

#include "cli/add_option.h"

namespace terrview {
namespace {

constexpr double kRadians = std::numbers::pi / 180;

void add_sun_options(CommandLine& app, LightOptions& light) {
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
  app.add_option("--sky-view", light.sky_azimuths,
                 "The sky lights valleys less: horizons in so many azimuths (default: evenly)")
      ->between(8, 128);
  time->excludes(sun)->excludes(shade);
}

void add_color(CommandLine& app, const std::string& name, std::optional<glm::vec3>& color,
               const std::string& help) {
  add_parsed(
      app, name, [&color, name](const std::string& text) { color = parse_color(name, text); }, help)
      ->type_name("R,G,B");
}

}  // namespace

void add_air_options(CommandLine& app, AirOptions& air) {
  auto* visibility = add_parsed(
                         app, "--visibility",
                         [&air](const std::string& text) {
                           air.visibility_km = parse_visibility("--visibility", text);
                         },
                         "Where a black ridge keeps 2 % of its contrast (default 60; inf: no air)")
                         ->type_name("KM");
  add_number(app, "--extinction", air.extinction_per_km,
             "Of the air, per km, instead of the visibility")
      ->excludes(visibility);
  add_color(app, "--air-color", air.color,
            "Of the air, sRGB 0-255 (default: the sky's at the horizon)");
  add_color(app, "--air-color-sun", air.sunward, "Of the air towards the sun");
  add_parsed(
      app, "--haze",
      [&air](const std::string& text) { air.haze_px = parse_number("--haze", text); },
      "Blur that grows with distance: pixels at the visibility (default 0)")
      ->type_name("S");
}

void add_sampling_options(CommandLine& app, ViewOptions& options) {
  auto* samples = app.add_option("--samples", options.sampling.samples,
                                 "Rays a pixel (1: through its centre; default: adaptive)")
                      ->between(1, 1024);
  auto* contrast =
      add_parsed(
          app, "--aa",
          [&options](const std::string& text) {
            options.sampling.contrast = parse_number("--aa", text);
          },
          "Adaptive: more rays where sRGB differs by more than this, 0-1 (default 0.03)")
          ->type_name("T");
  auto* preview = app.add_flag("--preview", options.sampling.preview,
                               "Blocks of 8 pixels, refined where they differ: a quick look");
  app.add_option("--progressive", options.progressive,
                 "A picture that is there at once and improves until it is the final one")
      ->type_name("FILE");
  samples->excludes(contrast)->excludes(preview);
  add_switch(app, "--lod", options.sampling.detail,
             "off: ground is not averaged where a pixel covers more than a post (default on)");
}

void add_light_options(CommandLine& app, ViewOptions& options) {
  add_sun_options(app, options.light);
  add_choice<NormalKind>(app, "--normals", options.normals,
                         {{"smooth", NormalKind::smooth}, {"facet", NormalKind::facet}},
                         "Light smooth ground (default) or its facets");
}

}  // namespace terrview

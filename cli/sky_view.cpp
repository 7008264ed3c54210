#include "cli/sky_view.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>

#include <nlohmann/json.hpp>

#include "cli/command_line.h"
#include "cli/parse.h"
#include "render/painted_sky.h"
#include "sky/sun.h"
#include "terrain/error.h"

namespace terrview {
namespace {

constexpr double kRadians = std::numbers::pi / 180;
// The Earth's curvature less that of light, for the geodetic coefficient of refraction 0.13.
constexpr double kCurvature_per_m = (1 - 0.13) / 6.371e6;

void add_angle(CommandLine& app, const std::string& name, double& value_rad,
               const std::string& help) {
  app.add_option_function<std::string>(
         name,
         [&value_rad, name](const std::string& text) {
           value_rad = parse_number(name, text) * kRadians;
         },
         help)
      ->type_name("DEGREES");
}

void add_camera_options(CommandLine& app, SkyPicture& view, bool& flat) {
  static const std::map<std::string, Projection> kProjections{
      {"perspective", Projection::perspective}, {"cylindrical", Projection::cylindrical}};
  view.camera.pitch_rad = 20 * kRadians;
  app.add_option_function<std::string>(
         "--projection",
         [&](const std::string& text) {
           flat = text == "flat";
           if (flat) return;
           view.camera.projection = kProjections.at(text);
           if (view.camera.projection == Projection::cylindrical) view.camera.pitch_rad = 0;
         },
         "flat (default), or as a camera sees it")
      ->one_of({"flat", "perspective", "cylindrical"})
      ->type_name("flat|perspective|cylindrical");
  add_angle(app, "--heading", view.camera.heading_rad, "Clockwise from north (default 0)");
  add_angle(app, "--pitch", view.camera.pitch_rad, "Up (default 20)");
  add_angle(app, "--roll", view.camera.roll_rad, "Clockwise (default 0)");
  add_angle(app, "--fov", view.camera.fov_rad, "Horizontal field of view (default 60)");
}

void add_layer_options(CommandLine& app, SkyPicture& view) {
  app.add_option("--altitude", view.layer.height_m, "Metres from the eye up to the clouds (2500)")
      ->between(10.0, 20000.0);
  app.add_option("--cell", view.layer.cell_m, "Metres: the side of a root cell (8000)")
      ->between(100.0, 100000.0);
  view.layer.curvature_per_m = kCurvature_per_m;
  app.add_option_function<std::string>(
         "--layer",
         [&](const std::string& text) {
           view.layer.curvature_per_m = text == "shell" ? kCurvature_per_m : 0;
         },
         "A shell that follows the Earth (default), or a plane")
      ->one_of({"shell", "plane"})
      ->type_name("shell|plane");
}

void add_light_options(CommandLine& app, SkyPicture& view) {
  app.add_option_function<std::string>(
         "--sun",
         [&](const std::string& text) {
           const auto sun = parse_numbers("--sun", text, 2, 2);
           if (std::abs(sun[1]) > 90)
             throw InputError("--sun " + text + ": the elevation is beyond 90 degrees");
           view.sun_azimuth_deg = sun[0];
           view.sun_elevation_deg = sun[1];
         },
         "Degrees (default 200,40)")
      ->type_name("AZ,EL");
  app.add_option_function<std::string>(
         "--sky-model",
         [&](const std::string& text) {
           view.sky.clear.model = text == "gradient" ? SkyModel::gradient : SkyModel::preetham;
         },
         "The sky behind the clouds: daylight (default), or a plain gradient")
      ->one_of({"preetham", "gradient"})
      ->type_name("preetham|gradient");
  app.add_option("--turbidity", view.sky.clear.turbidity, "2 very clear to 6 hazy (default 2.5)")
      ->between(2.0, 6.0);
  app.add_option("--leaf", view.sky.leaf_px, "Pixels under which a cell is not divided (default 1)")
      ->between(0.05, 64.0);
}

}  // namespace

void add_sky_view_options(CommandLine& app, SkyPicture& view, bool& flat) {
  add_camera_options(app, view, flat);
  add_layer_options(app, view);
  add_light_options(app, view);
}

Image paint_sky(const SkyOptions& sky, const SkyCamera& camera, int threads, ProgressBar& bar) {
  constexpr int kSide_px = CloudPainter::kWindow_px;
  const SkyPainter painter(sky, camera);
  Image image(camera.size_px.x, camera.size_px.y);
  const glm::ivec2 windows = (camera.size_px + (kSide_px - 1)) / kSide_px;
  parallel_for(windows.x * windows.y, threads, bar, [&](int index) {
    PixelWindow window;
    window.first_px = kSide_px * glm::ivec2(index % windows.x, index / windows.x);
    window.size_px = {std::min(kSide_px, camera.size_px.x - window.first_px.x),
                      std::min(kSide_px, camera.size_px.y - window.first_px.y)};
    const int pixels = window.size_px.x * window.size_px.y;
    window.wanted.assign(static_cast<std::size_t>(pixels), true);
    const std::vector<glm::vec3> colors = painter.paint(window);
    for (int k = 0; k < pixels; ++k)
      image.at(window.first_px.x + k % window.size_px.x, window.first_px.y + k / window.size_px.x) =
          colors[static_cast<std::size_t>(k)];
  });
  return image;
}

Image paint_sky_view(const SkyPicture& view, int threads, ProgressBar& bar) {
  const Camera camera(view.camera);
  SkyOptions sky = view.sky;
  sky.clear.towards_sun =
      towards({view.sun_azimuth_deg * kRadians, view.sun_elevation_deg * kRadians});
  if (sky.clouds) sky.clouds->layer = view.layer;
  return paint_sky(sky, sky_camera(camera), threads, bar);
}

nlohmann::ordered_json sky_view_json(const SkyPicture& view) {
  const CameraOptions& camera = view.camera;
  nlohmann::ordered_json json;
  json["projection"] = camera.projection == Projection::cylindrical ? "cylindrical" : "perspective";
  json["heading"] = camera.heading_rad / kRadians;
  json["pitch"] = camera.pitch_rad / kRadians;
  json["roll"] = camera.roll_rad / kRadians;
  json["fov"] = camera.fov_rad / kRadians;
  json["sun"] = {{"azimuth", view.sun_azimuth_deg}, {"elevation", view.sun_elevation_deg}};
  json["model"] = view.sky.clear.model == SkyModel::gradient ? "gradient" : "preetham";
  json["turbidity"] = view.sky.clear.turbidity;
  json["altitude_m"] = view.layer.height_m;
  json["cell_m"] = view.layer.cell_m;
  json["layer"] = view.layer.curvature_per_m == 0 ? "plane" : "shell";
  json["leaf_px"] = view.sky.leaf_px;
  return json;
}

}  // namespace terrview

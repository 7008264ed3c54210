#include "cli/view_sky.h"

#include <cmath>
#include <numbers>

#include "cli/add_option.h"
#include "cli/field_arguments.h"

namespace terrview {
namespace {

constexpr double kRadians = std::numbers::pi / 180;
constexpr double kEarthRadius_m = 6.371e6;
constexpr double kCloudsOverEye_m = 2000;

// The eye's place in the endless field: views from other places show the same clouds.
glm::dvec2 field_origin_m(const ViewFrame::Eye& eye) {
  if (!eye.geographic) return eye.projected;
  const double latitude_rad = eye.geographic->latitude_deg * kRadians;
  const double longitude_rad = eye.geographic->longitude_deg * kRadians;
  return kEarthRadius_m * glm::dvec2(longitude_rad * std::cos(latitude_rad), latitude_rad);
}

CloudLayer make_layer(const ViewSkyOptions& options, const ViewFrame& frame) {
  CloudLayer layer;
  layer.height_m = kCloudsOverEye_m;
  if (options.cloud_base)
    layer.height_m = options.cloud_base->height_m -
                     (options.cloud_base->above_ground ? 0 : frame.eye().height_m);
  const VerticalFrame& vertical = frame.terrain()->frame();
  layer.curvature_per_m = (1 - vertical.refraction) *
                          (vertical.east_curvature_per_m + vertical.north_curvature_per_m) / 2;
  layer.cell_m = options.cloud_cell_m;
  layer.origin_m = field_origin_m(frame.eye());
  return layer;
}

SkyOptions sky_options(const ViewSkyOptions& options, const ViewFrame& frame, const Scene& scene) {
  SkyOptions sky;
  sky.clear = {options.model, scene.light.towards_sun, options.turbidity};
  if (options.clouds > 0) {
    Clouds clouds;
    clouds.field.seed = options.seed;
    clouds.field.kind = FieldKind::smooth;
    clouds.field.levels = {12, 12};
    clouds.field.h = {0.6};
    clouds.layer = make_layer(options, frame);
    clouds.table = sky_table(options.clouds);
    sky.clouds = clouds;
  }
  return sky;
}

}  // namespace

void add_view_sky_options(CommandLine& app, ViewSkyOptions& sky) {
  add_parsed(
      app, "--sky", [&sky](const std::string& text) { sky.seed = parse_seed("--sky", text); },
      "Another number, other clouds (default 1)")
      ->type_name("SEED");
  app.add_option("--clouds", sky.clouds, "0 none to 1 overcast (default 0.35)")->between(0.0, 1.0);
  app.add_flag("--no-sky", sky.none, "A plain gradient");
  add_choice<SkyModel>(app, "--sky-model", sky.model,
                       {{"preetham", SkyModel::preetham}, {"gradient", SkyModel::gradient}},
                       "Behind the clouds: daylight (default), or a gradient of blue");
  app.add_option("--turbidity", sky.turbidity, "Of the daylight: 2 very clear to 6 hazy (2.5)")
      ->between(2.0, 6.0);
  add_parsed(
      app, "--cloud-base",
      [&sky](const std::string& text) { sky.cloud_base = parse_height("--cloud-base", text); },
      "Height of the clouds, or +H above the eye (default +2000)")
      ->type_name("METRES");
  app.add_option("--cloud-cell", sky.cloud_cell_m, "Side of the largest cloud cells (8000)")
      ->between(100.0, 100000.0)
      ->type_name("METRES");
  app.add_flag("--cloud-shadows", sky.cloud_shadows, "Clouds shade the ground");
}

std::shared_ptr<const PaintedSky> paint_view_sky(const ViewSkyOptions& options,
                                                 const ViewFrame& frame, const Camera& camera,
                                                 const Scene& scene) {
  if (options.none) return nullptr;
  return std::make_shared<const PaintedSky>(sky_options(options, frame, scene), camera,
                                            options.cloud_shadows);
}

std::shared_ptr<const PaintedSky> mirror_view_sky(const ViewSkyOptions& options,
                                                  const ViewFrame& frame, const Camera& camera,
                                                  const Scene& scene) {
  if (options.none) return nullptr;
  return PaintedSky::mirrored(sky_options(options, frame, scene), camera, options.cloud_shadows);
}

}  // namespace terrview

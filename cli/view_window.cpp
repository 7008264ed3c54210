#include "cli/view_window.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "cli/view_ground.h"
#include "cli/view_light.h"
#include "cli/view_setup.h"
#include "ingest/crs_transform.h"
#include "ingest/sight.h"
#include "ingest/visible_window.h"

namespace terrview {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kRadians = kPi / 180;

// Smaller files are read whole: that takes less than a blink.
constexpr double kSmall_posts = 4e6;

// The ground of the Earth lies between these.
constexpr double kLowest_m = -500;
constexpr double kHighest_m = 9000;

// A little flatter than the Earth anywhere, so that sight reaches a little too far.
constexpr double kFlatter_per_m = 1 / 6.41e6;

GeoPoint geographic(glm::dvec2 xy, const ViewOptions& options) {
  const DemHeader header = read_dem_header(options.dems.front(), options.dem);
  if (header.crs_wkt.empty()) return {std::nan(""), std::nan("")};
  const CrsTransform crs(header.name, header.crs_wkt, {&xy, 1});
  crs.to_geographic({&xy, 1});
  return {xy.y, xy.x};
}

GeoPoint eye_of(const ViewOptions& options) {
  return options.eye->geographic ? *options.eye->geographic
                                 : geographic(*options.eye->projected, options);
}

// What the options say of the aim: the pitch lies within `steepest_rad` of level.
struct Aim {
  double heading_rad;
  double steepest_rad;
};

Aim aim_of(const ViewOptions& options, GeoPoint eye) {
  const double pitch_rad = options.pitch_deg.value_or(0) * kRadians;
  if (options.heading_deg) return {*options.heading_deg * kRadians, std::abs(pitch_rad)};
  const Target& target = *options.look_at;
  const GeoPoint place =
      target.geographic ? *target.geographic : geographic(*target.projected, options);
  const glm::dvec2 ground_m = ground_from_geographic(eye, place);
  const double heading_rad = std::atan2(ground_m.x, ground_m.y);
  if (options.pitch_deg) return {heading_rad, std::abs(pitch_rad)};
  const double relief_m = options.z_scale.value_or(1) * (kHighest_m - kLowest_m) +
                          std::abs(options.eye->height_m) + std::abs(target.height.height_m);
  return {heading_rad, std::atan2(relief_m, glm::length(ground_m))};
}

// How far to either side a picture of this pitch reaches; pi where it shows the nadir or zenith.
double half_width(CameraOptions options, double pitch_rad) {
  options.heading_rad = 0;
  options.pitch_rad = pitch_rad;
  const Camera camera(options);
  const glm::dvec2 size(options.size_px);
  double widest = 0;
  constexpr int kSteps = 32;
  for (int i = 0; i <= kSteps; ++i) {
    const double share = static_cast<double>(i) / kSteps;
    for (const double side : {0.0, 1.0}) {
      for (const glm::dvec2 at : {glm::dvec2(share, side), glm::dvec2(side, share)}) {
        const glm::dvec3 direction = camera.ray(at * size).direction;
        widest = std::max(widest, std::abs(std::atan2(direction.x, direction.y)));
      }
    }
  }
  for (const double z : {-1.0, 1.0}) {
    const auto pole = camera.project({0, 0, z});
    if (pole && pole->x >= 0 && pole->y >= 0 && pole->x <= size.x && pole->y <= size.y) return kPi;
  }
  return widest;
}

double half_width(const ViewOptions& options, double steepest_rad) {
  const ResolvedView defaults;
  CameraOptions camera;
  camera.projection = options.projection.value_or(defaults.projection);
  camera.fov_rad = options.fov_deg.value_or(defaults.fov_deg) * kRadians;
  camera.size_px = options.size_px.value_or(defaults.size_px);
  camera.roll_rad = options.roll_deg.value_or(0) * kRadians;
  camera.shift = options.shift.value_or(camera.shift);
  if (camera.projection == Projection::cylindrical) return camera.fov_rad / 2;
  double widest = 0;
  for (const double share : {-1.0, -0.5, 0.0, 0.5, 1.0})
    widest = std::max(widest, half_width(camera, share * steepest_rad));
  constexpr double kBetweenSamples_rad = 2 * kRadians;
  return widest + kBetweenSamples_rad;
}

// How far off ground can shade what lies within `reach_m`.
double shadow_reach_m(const ViewOptions& options, const SunPosition& sun, double reach_m) {
  // Where the ground is far away, the sun stands lower over it by the angle between the plumb
  // lines.
  const double elevation_rad = sun.elevation_rad - reach_m * 1.1 / 6.37e6;
  if (!casts_shadows(options.light)) return 0;
  if (elevation_rad < kRadians) return reach_m;
  const double relief_m = options.z_scale.value_or(1) * (kHighest_m - kLowest_m);
  return std::min(reach_m, relief_m / std::tan(elevation_rad));
}

ViewSector sector_of(const ViewOptions& options) {
  ViewSector sector{.eye = eye_of(options)};
  const Aim aim = aim_of(options, sector.eye);
  sector.heading_rad = aim.heading_rad;
  sector.half_width_rad = half_width(options, aim.steepest_rad);

  const double z_scale = options.z_scale.value_or(1);
  VerticalFrame frame;
  frame.north_curvature_per_m = frame.east_curvature_per_m = kFlatter_per_m;
  frame.refraction = options.refraction.value_or(ResolvedView().refraction);
  frame.z_scale = z_scale;
  frame.eye_height_m = options.eye->above_ground ? z_scale * kHighest_m + options.eye->height_m
                                                 : z_scale * options.eye->height_m;
  sector.reach_m = sight_m(frame, z_scale * kLowest_m, z_scale * kHighest_m);

  const SunPosition sun = resolve_sun(options.light, {sector.eye, options.eye->height_m});
  sector.sun_azimuth_rad = sun.azimuth_rad;
  sector.shadow_m = shadow_reach_m(options, sun, sector.reach_m);
  return sector;
}

}  // namespace

void limit_reading(ViewOptions& options) {
  const bool aimed = options.heading_deg || options.look_at;
  // Shares of the range of heights are of the whole file's, and so are the shores of lakes.
  const bool of_whole = has_ramp_file(options) || !options.water.file.empty();
  if (!aimed || options.plan || options.earth == EarthModel::flat || options.dem.window ||
      options.dem.choose_window || of_whole || options.projection == Projection::orthographic)
    return;
  const auto is_large = [&](const std::string& path) {
    const DemHeader header = read_dem_header(path, options.dem);
    return static_cast<double>(header.columns) * header.rows > kSmall_posts;
  };
  if (std::none_of(options.dems.begin(), options.dems.end(), is_large)) return;
  const ViewSector sector = sector_of(options);
  if (!std::isfinite(sector.eye.latitude_deg)) return;
  options.dem.choose_window = [sector](const DemHeader& header) -> std::optional<PostWindow> {
    const bool small = static_cast<double>(header.columns) * header.rows <= kSmall_posts;
    if (small) return PostWindow{0, 0, header.columns, header.rows};
    return visible_window(header, sector);
  };
}

}  // namespace terrview

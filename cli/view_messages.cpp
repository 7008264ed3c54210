#include "cli/view_messages.h"

#include <cstdio>
#include <numbers>

namespace terrview {
namespace {

void say_how_it_was_placed(const ViewFrame& frame) {
  for (const CrsOperation& operation : frame.operations()) {
    std::fprintf(stderr, "%s: %s, accuracy ", operation.dem.c_str(), operation.name.c_str());
    if (operation.accuracy_m)
      std::fprintf(stderr, "%g m\n", *operation.accuracy_m);
    else
      std::fprintf(stderr, "unknown\n");
  }
  for (const std::string& warning : frame.warnings())
    std::fprintf(stderr, "warning: %s\n", warning.c_str());
}

void say_where_the_eye_is(const View& view) {
  const ViewFrame::Eye& eye = view.frame.eye();
  if (eye.geographic)
    std::fprintf(stderr, "eye: %.6f, %.6f", eye.geographic->latitude_deg,
                 eye.geographic->longitude_deg);
  else
    std::fprintf(stderr, "eye: x %.2f, y %.2f", eye.projected.x, eye.projected.y);
  std::fprintf(stderr, ", %.2f m", eye.height_m);
  if (eye.ground_m)
    std::fprintf(stderr, " (ground %.2f m)\n", *eye.ground_m);
  else
    std::fprintf(stderr, " (no ground below)\n");
  std::fprintf(stderr, "heading %.3f, pitch %.3f degrees; ", view.resolved.heading_deg,
               view.resolved.pitch_deg);
  if (view.frame.terrain()->frame().east_curvature_per_m == 0)
    std::fprintf(stderr, "flat Earth\n");
  else
    std::fprintf(stderr, "curved Earth, refraction k %g (multiplier 1-k = %g)\n",
                 view.resolved.refraction, 1 - view.resolved.refraction);
}

void say_where_the_sun_is(const SunPosition& sun) {
  constexpr double kDegrees = 180 / std::numbers::pi;
  const double elevation_deg = sun.elevation_rad * kDegrees;
  std::fprintf(stderr, "sun: azimuth %.3f, elevation %.3f degrees\n", sun.azimuth_rad * kDegrees,
               elevation_deg);
  if (elevation_deg < 0)
    std::fprintf(stderr, "the sun is %.1f degrees below the horizon: %s\n", -elevation_deg,
                 elevation_deg > -18 ? "dusk" : "night");
}

}  // namespace

void say_what_was_read(const std::vector<Dem>& dems) {
  for (const Dem& dem : dems) {
    std::fprintf(stderr, "%s: %d x %d posts", dem.name.c_str(), dem.grid->columns, dem.grid->rows);
    if (dem.voids_filled > 0) std::fprintf(stderr, ", %zu void posts filled", dem.voids_filled);
    if (dem.voids_open > 0) std::fprintf(stderr, ", %zu void posts open", dem.voids_open);
    std::fputc('\n', stderr);
    for (const std::string& warning : dem.warnings)
      std::fprintf(stderr, "warning: %s\n", warning.c_str());
  }
}

void say_what_is_seen(const std::vector<Dem>& dems, const View& view) {
  say_what_was_read(dems);
  say_how_it_was_placed(view.frame);
  for (const std::string& line : view.objects.messages) std::fprintf(stderr, "%s\n", line.c_str());
  for (const std::string& line : view.labels.messages) std::fprintf(stderr, "%s\n", line.c_str());
  if (view.resolved.plan)
    std::fprintf(stderr, "plan: %d x %d pixels\n", view.resolved.size_px.x,
                 view.resolved.size_px.y);
  else
    say_where_the_eye_is(view);
  say_where_the_sun_is(view.sun);
}

}  // namespace terrview

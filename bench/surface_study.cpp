#include "bench/surface_study.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "terrain/grid_walk.h"

namespace terrview {
namespace {

// Far enough before a point that the chord over it does not depend on where the walk began.
constexpr double kApproach_cells = 4;
constexpr glm::ivec2 kProbe_px{96, 54};
constexpr double kPictureWide_px = 1920;
// A walker's eye may stand still over a point that it sees; a millimetre away it has no direction.
constexpr double kNearest_m = 1e-3;

Spread spread_of(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
  };
  return {at(0.5), at(0.99), values.back()};
}

// Points of the ground that the view shows, in posts.
std::vector<glm::dvec2> points_seen(const BenchDem& dem, const BenchView& view) {
  CameraOptions options = view.camera.options();
  options.size_px = kProbe_px;
  const Camera camera(options);
  const Terrain terrain = terrain_of(dem, view, SurfaceModel::bilinear, Search::pyramid);
  std::vector<glm::dvec2> points;
  for (int row = 0; row < kProbe_px.y; ++row)
    for (int column = 0; column < kProbe_px.x; ++column)
      if (const auto hit = terrain.first_hit(camera.ray({column + 0.5, row + 0.5})))
        points.push_back(hit->uv);
  return points;
}

// What a pixel of height is worth at a ground distance of one metre.
double focal_px(const Camera& camera) {
  return kPictureWide_px / 2 / std::tan(camera.options().fov_rad / 2);
}

// Where the eye is in each frame: sideways, a metre apart, over the width of a cell.
std::vector<glm::dvec2> eyes_on_path(const BenchDem& dem, const BenchView& view) {
  const double heading = view.camera.options().heading_rad;
  const glm::dvec2 sideways =
      glm::inverse(dem.step_m) * glm::dvec2(std::cos(heading), -std::sin(heading));
  const int frames = std::max(8, static_cast<int>(std::ceil(glm::length(dem.step_m[0]))));
  const double step_m = std::min(1.0, glm::length(dem.step_m[0]) / frames);
  std::vector<glm::dvec2> eyes;
  for (int frame = 0; frame <= frames; ++frame)
    eyes.push_back(view.eye_uv + step_m * frame * sideways);
  return eyes;
}

}  // namespace

double height_seen_m(const BenchDem& dem, SurfaceModel model, glm::dvec2 eye_uv,
                     glm::dvec2 point_uv) {
  const HeightGrid& grid = *dem.grid;
  const AffineGroundMap map(eye_uv, glm::inverse(dem.step_m), {grid.columns, grid.rows});
  const glm::dvec2 to_point_m = dem.step_m * (point_uv - eye_uv);
  const double distance_m = glm::length(to_point_m);
  if (distance_m < kNearest_m) return height_at(grid, model, cell_of(grid, point_uv), point_uv);
  const GroundLine line{{0, 0}, to_point_m / distance_m};
  const double cell_m = std::max(glm::length(dem.step_m[0]), glm::length(dem.step_m[1]));
  GridWalk walk(grid, map, model, line, std::max(0.0, distance_m - kApproach_cells * cell_m),
                distance_m + kApproach_cells * cell_m);
  for (Span span; walk.next(span);) {
    const double length_m = span.out.g_m - span.in.g_m;
    if (span.out.g_m < distance_m || !(length_m > 0)) continue;
    const double t = std::clamp((distance_m - span.in.g_m) / length_m, 0.0, 1.0);
    const double chord_m = std::lerp(span.in.height_m, span.out.height_m, t);
    return chord_m - span.sag_m * t * (1 - t);
  }
  return height_at(grid, model, cell_of(grid, point_uv), point_uv);
}

Motion ground_motion(const BenchDem& dem, const BenchView& view, SurfaceModel model) {
  const std::vector<glm::dvec2> points = points_seen(dem, view);
  const std::vector<glm::dvec2> eyes = eyes_on_path(dem, view);
  const double focal = focal_px(view.camera);
  std::vector<double> steps_m;
  std::vector<double> steps_px;
  double sweep_px = 0;
  for (const glm::dvec2 point : points) {
    double before_m = height_seen_m(dem, model, eyes[0], point);
    double lowest_m = before_m;
    double highest_m = before_m;
    double px_per_m = 0;
    for (std::size_t frame = 1; frame < eyes.size(); ++frame) {
      const double now_m = height_seen_m(dem, model, eyes[frame], point);
      const glm::dvec3 to_point_m(dem.step_m * (point - eyes[frame]), now_m - view.eye_m.z);
      const double level_m = glm::length(glm::dvec2(to_point_m));
      // A change of the elevation angle, in pixels of the middle of the picture.
      px_per_m = focal * level_m / glm::dot(to_point_m, to_point_m);
      steps_m.push_back(std::abs(now_m - before_m));
      steps_px.push_back(steps_m.back() * px_per_m);
      lowest_m = std::min(lowest_m, now_m);
      highest_m = std::max(highest_m, now_m);
      before_m = now_m;
    }
    sweep_px = std::max(sweep_px, (highest_m - lowest_m) * px_per_m);
  }
  return {spread_of(std::move(steps_m)), spread_of(std::move(steps_px)), sweep_px};
}

HeightErrors errors_at_dropped_posts(const BenchDem& dem, SurfaceModel model, DroppedPosts which) {
  const HeightGrid& fine = *dem.grid;
  HeightGrid coarse{(fine.columns + 1) / 2, (fine.rows + 1) / 2, {}};
  for (int row = 0; row < coarse.rows; ++row)
    for (int column = 0; column < coarse.columns; ++column)
      coarse.heights_m.push_back(fine.at(2 * column, 2 * row));
  const BenchDem thinned{dem.name, std::make_shared<const HeightGrid>(coarse), 2.0 * dem.step_m};
  // Some of the posts of a large grid are enough.
  const int stride = std::max(1, std::max(coarse.columns, coarse.rows) / 256);
  constexpr int kAzimuths = 8;
  const std::vector<glm::dvec2> places = which == DroppedPosts::in_cells
                                             ? std::vector<glm::dvec2>{{0.5, 0.5}}
                                             : std::vector<glm::dvec2>{{0.5, 0}, {0, 0.5}};
  std::vector<double> errors;
  double sum = 0;
  for (int row = 0; row + 1 < coarse.rows; row += stride)
    for (int column = 0; column + 1 < coarse.columns; column += stride)
      for (const glm::dvec2& place : places) {
        const glm::dvec2 point = glm::dvec2(column, row) + place;
        const glm::ivec2 post(2.0 * point);
        const double true_m = fine.at(post.x, post.y);
        for (int i = 0; i < kAzimuths; ++i) {
          const double azimuth = 2 * std::numbers::pi * (i + 0.5) / kAzimuths;
          const glm::dvec2 eye = point + 10.0 * glm::dvec2(std::cos(azimuth), std::sin(azimuth));
          errors.push_back(std::abs(height_seen_m(thinned, model, eye, point) - true_m));
          sum += errors.back() * errors.back();
        }
      }
  const double rms_m = errors.empty() ? 0 : std::sqrt(sum / static_cast<double>(errors.size()));
  const Spread spread = spread_of(std::move(errors));
  return {rms_m, spread.p99, spread.most};
}

}  // namespace terrview

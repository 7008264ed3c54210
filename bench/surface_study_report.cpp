#include <numbers>
#include <ostream>

#include "bench/scalar_rays.h"
#include "bench/study_text.h"
#include "bench/surface_study.h"

namespace terrview {
namespace {

struct Cost {
  double ns_per_ray;
  double tests_per_ray;
};

Cost cost_of(const Terrain& terrain, const BenchView& view) {
  TracedFrame frame(view.camera.options().size_px);
  const double start_s = thread_seconds();
  const FrameWork work = trace_rays(terrain, view.camera, 1, frame);
  const double spent_s = thread_seconds() - start_s;
  const auto rays = static_cast<double>(frame.pixels());
  return {1e9 * spent_s / rays, static_cast<double>(work.tests.value_or(0)) / rays};
}

void print_view_study(std::ostream& out, const BenchDem& dem, const BenchView& view) {
  out << "\n"
      << dem.name << ", " << view.name << "\n"
      << "  surface        moves a frame, m: p50      p99      max   pixels: p50      p99      max"
         "  whole path   ns/ray: plain  pyramid  tests\n";
  for (const SurfaceModel model : kSurfaceModels) {
    const Motion motion = ground_motion(dem, view, model);
    const Cost plain = cost_of(terrain_of(dem, view, model, Search::plain), view);
    const Cost fast = cost_of(terrain_of(dem, view, model, Search::pyramid), view);
    print_line(out, "  %-12s %22.2g %8.2g %8.2g %13.2g %8.2g %8.2g %11.2g %15.0f %8.0f %6.1f",
               name_of(model), motion.height_m.p50, motion.height_m.p99, motion.height_m.most,
               motion.screen_px.p50, motion.screen_px.p99, motion.screen_px.most, motion.sweep_px,
               plain.ns_per_ray, fast.ns_per_ray, plain.tests_per_ray);
  }
}

}  // namespace

BenchView walkers_view(const BenchDem& dem, glm::ivec2 size_px) {
  constexpr double kDegree = std::numbers::pi / 180;
  BenchView view = six_views(dem, size_px)[2];
  CameraOptions camera = view.camera.options();
  camera.pitch_rad = -3 * kDegree;
  return make_view(dem, "walk", {view.eye_uv, dem.height_m(view.eye_uv) + 2}, camera);
}

void print_surface_study(std::ostream& out, const BenchDem& dem, glm::ivec2 size_px) {
  print_view_study(out, dem, walkers_view(dem, size_px));
  for (const BenchView& view : six_views(dem, size_px))
    if (view.name == "horizon" || view.name == "valley" || view.name == "oblique")
      print_view_study(out, dem, view);
  out << "\n"
      << dem.name << ", heights of the posts dropped so that cells are twice as wide\n"
      << "  surface        in cells: rms, m      p99      max   on edges: rms, m      p99      "
         "max\n";
  for (const SurfaceModel model : kSurfaceModels) {
    const HeightErrors cells = errors_at_dropped_posts(dem, model, DroppedPosts::in_cells);
    const HeightErrors edges = errors_at_dropped_posts(dem, model, DroppedPosts::on_edges);
    print_line(out, "  %-12s %18.3f %8.3f %8.3f %18.3f %8.3f %8.3f", name_of(model), cells.rms_m,
               cells.p99_m, cells.most_m, edges.rms_m, edges.p99_m, edges.most_m);
  }
}

}  // namespace terrview

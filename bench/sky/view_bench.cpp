#include <cstdio>

#include <glm/geometric.hpp>

#include "bench/sky/field_bench.h"
#include "cli/prepare_view.h"
#include "cli/view_options.h"
#include "cli/view_setup.h"
#include "ingest/dem.h"
#include "render/painted_sky.h"
#include "render/render.h"

namespace terrview {
namespace {

// One ray a pixel: the sky is painted for pixels too.
Frame render_once(const Scene& scene, const Camera& camera) {
  return render(scene, camera, {.threads = 1, .samples = 1});
}

}  // namespace

void print_view(const std::vector<std::string>& args) {
  ViewOptions options = parse_view(args, "terrview-sky-bench");
  const std::vector<Dem> dems = read_dems(options.dems, options.dem);
  const ViewSkyOptions sky = options.sky;
  options.sky.none = true;
  View view = make_view(options, dems);
  const Frame frame = render_once(view.scene, view.camera);
  const double plain = seconds_of([&] { static_cast<void>(render_once(view.scene, view.camera)); });
  options.sky = sky;
  const double clouded = seconds_of([&] {
    const View painted = make_view(options, dems);
    static_cast<void>(render_once(painted.scene, painted.camera));
  });
  const double made = seconds_of([&] { static_cast<void>(make_view(options, dems)); });
  const auto ground = static_cast<double>(frame.counts.hits);
  const auto all = static_cast<double>(frame.counts.rays);
  std::printf(
      "\nA view of %d x %d pixels, one ray a pixel, one thread: %.0f %% ground\n"
      "ground, and a plain gradient   %6.3f s  (%.0f ns a ground pixel)\n"
      "the sky instead of a gradient  %6.3f s  (%.0f ns a sky pixel)\n",
      view.camera.options().size_px.x, view.camera.options().size_px.y, 100 * ground / all, plain,
      1e9 * plain / ground, clouded - made - plain,
      1e9 * (clouded - made - plain) / (all - ground));
}

}  // namespace terrview

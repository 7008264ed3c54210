#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "bench/bench_view.h"
#include "bench/light_study.h"
#include "bench/psnr.h"
#include "bench/study_text.h"
#include "render/daylight.h"
#include "render/render.h"
#include "render/shadows.h"
#include "render/sky_light.h"

namespace terrview {
namespace {

struct Effect {
  std::string name;
  Scene scene;
  RenderOptions options;
};

Scene bare_scene(const BenchDem& dem, const BenchView& view) {
  Scene scene;
  scene.terrain = std::make_shared<const Terrain>(
      terrain_of(dem, view, SurfaceModel::hyperboloid, Search::pyramid));
  const Daylight day = daylight(std::asin(view.to_sun.z));
  scene.light = {.towards_sun = view.to_sun, .sun = day.sun, .ambient = day.ambient};
  scene.sky = day.sky;
  return scene;
}

// An effect alone is a change to the bare scene and its rays.
std::vector<Effect> make_effects(const Scene& bare, double reach_m) {
  const RenderOptions one{.threads = 1};
  std::vector<Effect> effects{{"none: one ray a pixel, hard shadows", bare, one},
                              {"none, again", bare, one}};
  const auto add = [&](const char* name, const auto& change) {
    effects.push_back({name, bare, one});
    change(effects.back());
  };
  const double visibility_m = reach_m / 2;
  add("no shadows", [](Effect& e) { e.scene.light.casts_shadows = false; });
  add("soft shadows", [](Effect& e) { e.scene.light.sun_radius_rad = kSunRadius_rad; });
  add("air",
      [&](Effect& e) { e.scene.air.extinction_per_m = kExtinctionTimesVisibility / visibility_m; });
  add("level of detail",
      [&](Effect& e) { e.scene.detail = std::make_shared<const GroundDetail>(*bare.terrain); });
  add("sky view, once swept", [&](Effect& e) {
    e.scene.sky_views =
        std::make_shared<const std::vector<SkyView>>(sky_views(*bare.terrain, {.azimuths = 16}));
  });
  add("adaptive rays", [](Effect& e) { e.options.samples = 0; });
  add("16 rays a pixel", [](Effect& e) { e.options.samples = 16; });
  add("haze", [&](Effect& e) { e.scene.air.haze_px_per_m = 2 / visibility_m; });
  add("haze, every pixel traced", [&](Effect& e) {
    e.scene.air.haze_px_per_m = 2 / visibility_m;
    e.options.sparse_haze = false;
  });
  add("preview", [](Effect& e) { e.options.preview = true; });
  add("progressive", [](Effect& e) { e.options.improved = [](const Image&) {}; });
  return effects;
}

struct Cost {
  std::vector<double> seconds;
  std::int64_t rays = 0;
  std::int64_t shadow_rays = 0;

  [[nodiscard]] double median_s() {
    std::sort(seconds.begin(), seconds.end());
    return seconds[seconds.size() / 2];
  }
};

// Half of the ground in the picture lies nearer.
double median_distance_m(const Scene& bare, const Camera& camera) {
  std::vector<double> distances_m;
  const Frame frame = render(bare, camera, {.keep_samples = true});
  for (const PixelSample& sample : frame.samples.pixels()) {
    if (sample.object_id != PixelSample::kNothing)
      distances_m.push_back(glm::length(sample.position_m));
  }
  const auto middle = distances_m.begin() + static_cast<std::ptrdiff_t>(distances_m.size() / 2);
  std::nth_element(distances_m.begin(), middle, distances_m.end());
  return *middle;
}

void print_haze(std::ostream& out, const Scene& bare, const Camera& camera) {
  print_line(out, "%s", "\nhaze: rays spared, and the picture beside that of every pixel traced");
  const double middle_m = median_distance_m(bare, camera);
  for (const double blur_px : {0.5, 1.0, 2.0, 4.0}) {
    Scene scene = bare;
    scene.air.haze_px_per_m = blur_px / middle_m;
    const Frame sparse = render(scene, camera);
    const Frame full = render(scene, camera, {.sparse_haze = false});
    print_line(
        out, "  %g px at the median distance: %5.1f %% of the rays spared, PSNR %.1f dB", blur_px,
        100 * (1 - static_cast<double>(sparse.counts.rays) / static_cast<double>(full.counts.rays)),
        psnr_db(sparse.image, full.image));
  }
}

// All of the DEM from so high above that a pixel covers several posts.
BenchView far_view(const BenchDem& dem) {
  constexpr double kHeights = 3;  // in extents
  return make_view(dem, "far", {dem.middle_uv(), kHeights * dem.extent_m()},
                   {.pitch_rad = -std::numbers::pi / 2,
                    .fov_rad = 2 * std::atan(0.4 / kHeights),
                    .size_px = {480, 480}});
}

void print_sparkle(std::ostream& out, const BenchDem& dem) {
  const BenchView view = far_view(dem);
  const Scene bare = bare_scene(dem, view);
  Scene averaged = bare;
  averaged.detail = std::make_shared<const GroundDetail>(*bare.terrain);
  CameraOptions turned = view.camera.options();
  turned.pitch_rad += 0.1 * view.camera.per_px();
  print_line(out,
             "\nsparkle, %.1f posts a pixel: change of the picture when the camera turns by a "
             "tenth of a pixel, rms in sRGB",
             0.8 * dem.extent_m() / 480 / glm::length(dem.step_m[0]));
  for (const int samples : {1, 0}) {
    const auto change = [&](const Scene& scene) {
      const Image before = render(scene, view.camera, {.samples = samples}).image;
      const Image after = render(scene, Camera(turned), {.samples = samples}).image;
      return std::pow(10, -psnr_db(before, after) / 20);
    };
    print_line(out, "  %s: posts as they are %.4f, level of detail %.4f",
               samples == 1 ? "one ray a pixel" : "adaptive rays", change(bare), change(averaged));
  }
}

}  // namespace

void print_effect_costs(std::ostream& out, const BenchDem& dem, glm::ivec2 size_px,
                        int repetitions) {
  const std::vector<BenchView> views = six_views(dem, size_px);
  const auto view = std::find_if(views.begin(), views.end(),
                                 [](const BenchView& v) { return v.name == "oblique"; });
  const Scene bare = bare_scene(dem, *view);
  const double reach_m = dem.extent_m();
  const std::vector<Effect> effects = make_effects(bare, reach_m);
  std::vector<Cost> costs(effects.size());
  for (int i = 0; i < repetitions; ++i) {
    for (std::size_t e = 0; e < effects.size(); ++e) {
      const double start_s = thread_seconds();
      const Frame frame = render(effects[e].scene, view->camera, effects[e].options);
      costs[e].seconds.push_back(thread_seconds() - start_s);
      costs[e].rays = frame.counts.rays;
      costs[e].shadow_rays = frame.counts.shadow_rays;
    }
  }
  const double megapixels = size_px.x * size_px.y / 1e6;
  print_line(out, "\n%s, view oblique, %d x %d, one thread: processor time per megapixel",
             dem.name.c_str(), size_px.x, size_px.y);
  for (std::size_t e = 0; e < effects.size(); ++e)
    print_line(out, "  %-36s %8.1f ms %+8.1f %%  %6.2f rays, %5.2f shadow rays a pixel",
               effects[e].name.c_str(), 1000 * costs[e].median_s() / megapixels,
               100 * (costs[e].median_s() / costs[0].median_s() - 1),
               static_cast<double>(costs[e].rays) / (1e6 * megapixels),
               static_cast<double>(costs[e].shadow_rays) / (1e6 * megapixels));
  print_haze(out, bare, view->camera);
  print_sparkle(out, dem);
}

}  // namespace terrview

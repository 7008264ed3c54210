#include "bench/measure.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <functional>
#include <map>
#include <numeric>
#include <utility>

#include "bench/frame_errors.h"
#include "bench/plain.h"

namespace terrview {
namespace {

// What every contender of one surface is compared with.
struct Reference {
  TracedFrame frame;
  ShadowRays rays;
  ShadowFrame shadow;
};

BenchScene make_scene(const BenchDem& dem, const BenchView& view,
                      const std::vector<Contender>& contenders) {
  BenchScene scene{dem, view, {}};
  for (const Contender& contender : contenders)
    if (contender.surface && !scene.terrains.contains(*contender.surface))
      scene.terrains.emplace(*contender.surface, terrain_of(dem, view, *contender.surface));
  return scene;
}

std::map<SurfaceModel, Reference> make_references(const BenchScene& scene) {
  std::map<SurfaceModel, Reference> references;
  for (const auto& [surface, terrain] : scene.terrains) {
    TracedFrame frame(scene.view.camera.options().size_px);
    trace_plain(terrain, scene.view.camera, 0, frame);
    ShadowRays rays = shadow_rays(terrain, scene.view, frame);
    ShadowFrame shadow(frame.pixels());
    shade_plain(terrain, scene.view, rays, 0, shadow);
    references.emplace(surface, Reference{std::move(frame), std::move(rays), std::move(shadow)});
  }
  return references;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

// The median seconds of each of `runs`, taken in turns; check(i) follows the first of each.
std::vector<double> time_in_turns(const std::vector<std::function<void()>>& runs,
                                  const std::function<void(std::size_t)>& check,
                                  const MeasureOptions& options) {
  std::vector<std::vector<double>> seconds(runs.size());
  for (int turn = 0; turn < options.repetitions; ++turn)
    for (std::size_t i = 0; i < runs.size(); ++i) {
      if (std::reduce(seconds[i].begin(), seconds[i].end()) > options.budget_s) continue;
      const auto start = std::chrono::steady_clock::now();
      runs[i]();
      const auto end = std::chrono::steady_clock::now();
      seconds[i].push_back(std::chrono::duration<double>(end - start).count());
      if (turn == 0) check(i);
    }
  std::vector<double> medians;
  for (std::vector<double>& each : seconds) medians.push_back(median(std::move(each)));
  return medians;
}

BenchResult describe(const BenchScene& scene, const Contender& contender, const char* rays,
                     int threads) {
  BenchResult result{.dem = scene.dem.name,
                     .view = scene.view.name,
                     .rays = rays,
                     .contender = contender.name,
                     .threads = threads};
  if (contender.surface) result.surface = name_of(*contender.surface);
  result.build_s = contender.build_s;
  result.memory_mib = contender.memory_mib;
  return result;
}

void set_speed(BenchResult& result, const FrameWork& work, std::int64_t rays, double seconds) {
  const auto count = static_cast<double>(rays);
  result.mrays_per_s = count / seconds / 1e6;
  if (work.tests) result.tests_per_ray = static_cast<double>(*work.tests) / count;
  if (work.nodes) result.nodes_per_ray = static_cast<double>(*work.nodes) / count;
}

void set_errors(BenchResult& result, const FrameErrors& errors) {
  result.cells_differ = errors.cells_differ;
  result.hit_flips = errors.hit_flips;
  result.p50_rel_error = errors.p50_rel_error;
  result.p99_rel_error = errors.p99_rel_error;
  result.max_rel_error = errors.max_rel_error;
}

class Measurement {
 public:
  Measurement(const BenchDem& dem, const BenchView& view, const std::vector<Contender>& contenders,
              const MeasureOptions& options)
      : contenders_(contenders),
        options_(options),
        scene_(make_scene(dem, view, contenders)),
        references_(make_references(scene_)) {}

  void primary(int threads, std::vector<BenchResult>& results) const {
    TracedFrame frame(scene_.view.camera.options().size_px);
    std::vector<BenchResult> measured;
    std::vector<FrameWork> work(contenders_.size());
    std::vector<std::function<void()>> runs;
    for (std::size_t i = 0; i < contenders_.size(); ++i) {
      measured.push_back(describe(scene_, contenders_[i], "primary", threads));
      runs.emplace_back([&, i] { work[i] = contenders_[i].primary(scene_, threads, frame); });
    }
    const auto check = [&](std::size_t i) {
      if (contenders_[i].surface)
        set_errors(measured[i],
                   frame_errors(references_.at(*contenders_[i].surface).frame, frame));
      frame.clear();  // so that no contender passes off what another wrote
    };
    const std::vector<double> seconds = time_in_turns(runs, check, options_);
    for (std::size_t i = 0; i < runs.size(); ++i) {
      set_speed(measured[i], work[i], static_cast<std::int64_t>(frame.pixels()), seconds[i]);
      results.push_back(std::move(measured[i]));
    }
  }

  void shadow(int threads, std::vector<BenchResult>& results) const {
    std::vector<BenchResult> measured;
    std::vector<const Reference*> references;
    std::vector<FrameWork> work(contenders_.size());
    std::vector<std::function<void()>> runs;
    ShadowFrame frame(TracedFrame(scene_.view.camera.options().size_px).pixels());
    for (const Contender& contender : contenders_) {
      if (!contender.shadow) continue;
      const Reference& reference = references_.at(*contender.surface);
      if (reference.rays.count == 0) continue;
      FrameWork& its_work = work[runs.size()];
      runs.emplace_back(
          [&] { its_work = contender.shadow(scene_, reference.rays, threads, frame); });
      references.push_back(&reference);
      measured.push_back(describe(scene_, contender, "shadow", threads));
    }
    const auto check = [&](std::size_t i) {
      measured[i].hit_flips = shadow_flips(references[i]->shadow, frame);
      std::fill(frame.begin(), frame.end(), std::uint8_t{2});
    };
    const std::vector<double> seconds = time_in_turns(runs, check, options_);
    for (std::size_t i = 0; i < runs.size(); ++i) {
      set_speed(measured[i], work[i], references[i]->rays.count, seconds[i]);
      results.push_back(std::move(measured[i]));
    }
  }

 private:
  const std::vector<Contender>& contenders_;
  const MeasureOptions& options_;
  BenchScene scene_;
  std::map<SurfaceModel, Reference> references_;
};

}  // namespace

std::vector<BenchResult> measure(const BenchDem& dem, const BenchView& view,
                                 const std::vector<Contender>& contenders,
                                 const MeasureOptions& options) {
  const Measurement measurement(dem, view, contenders, options);
  std::vector<BenchResult> results;
  for (const int threads : options.threads) measurement.primary(threads, results);
  for (const int threads : options.threads) measurement.shadow(threads, results);
  return results;
}

}  // namespace terrview

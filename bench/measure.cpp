#include "bench/measure.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <functional>
#include <iterator>
#include <map>
#include <numeric>
#include <utility>

#include "bench/scalar_rays.h"
#include "bench/trace_errors.h"

namespace terrview {
namespace {

// What every contender of one surface is compared with.
struct Reference {
  TracedFrame frame;
  ShadowRays rays;
  ShadowFrame shadow;
};

Reference make_reference(const Terrain& terrain, const BenchView& view) {
  TracedFrame frame(view.camera.options().size_px);
  trace_rays(terrain, view.camera, 0, frame);
  ShadowRays rays = shadow_rays(terrain, view, frame);
  ShadowFrame shadow(frame.pixels());
  shade_rays(terrain, view, rays, 0, shadow);
  return {std::move(frame), std::move(rays), std::move(shadow)};
}

std::map<SurfaceModel, Reference> make_references(const BenchDem& dem, const BenchView& view,
                                                  const std::vector<Contender>& contenders) {
  std::map<SurfaceModel, Reference> references;
  for (const Contender& contender : contenders)
    if (contender.surface && !references.contains(*contender.surface))
      references.emplace(
          *contender.surface,
          make_reference(terrain_of(dem, view, *contender.surface, Search::plain), view));
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

void set_speed(BenchResult& result, const FrameWork& work, std::int64_t rays, double seconds) {
  const auto count = static_cast<double>(rays);
  result.mrays_per_s = count / seconds / 1e6;
  if (work.tests) result.tests_per_ray = static_cast<double>(*work.tests) / count;
  if (work.nodes) result.nodes_per_ray = static_cast<double>(*work.nodes) / count;
}

void set_errors(BenchResult& result, const TraceErrors& errors) {
  result.cells_differ = errors.cells_differ;
  result.hit_flips = errors.hit_flips;
  result.p50_rel_error = errors.p50_rel_error;
  result.p99_rel_error = errors.p99_rel_error;
  result.max_rel_error = errors.max_rel_error;
}

// One kind of rays with one number of threads: every contender, its results and its work.
class Round {
 public:
  // Traces one frame.
  using Run = std::function<FrameWork()>;

  void add(const Run& run, std::int64_t rays, BenchResult result) {
    const std::size_t i = results_.size();
    runs_.emplace_back([this, run, i] { work_[i] = run(); });
    rays_.push_back(rays);
    work_.emplace_back();
    results_.push_back(std::move(result));
  }

  // check(i, result) compares the frame that the i-th has just written for the first time.
  template <class Check>
  std::vector<BenchResult> time(const MeasureOptions& options, Check check) {
    const std::vector<double> seconds = time_in_turns(
        runs_, [&](std::size_t i) { check(i, results_[i]); }, options);
    for (std::size_t i = 0; i < runs_.size(); ++i)
      set_speed(results_[i], work_[i], rays_[i], seconds[i]);
    return std::move(results_);
  }

 private:
  std::vector<std::function<void()>> runs_;
  std::vector<std::int64_t> rays_;
  std::vector<FrameWork> work_;
  std::vector<BenchResult> results_;
};

class Measurement {
 public:
  Measurement(const BenchDem& dem, const BenchView& view, const std::vector<Contender>& contenders,
              const MeasureOptions& options)
      : dem_(dem),
        view_(view),
        options_(options),
        references_(make_references(dem, view, contenders)) {
    for (const Contender& contender : contenders)
      entries_.push_back({contender, contender.place(view),
                          contender.surface ? &references_.at(*contender.surface) : nullptr});
  }

  [[nodiscard]] std::vector<BenchResult> primary(int threads) const {
    TracedFrame frame(view_.camera.options().size_px);
    Round round;
    for (const Entry& entry : entries_)
      round.add([&] { return entry.tracer.primary(threads, frame); },
                static_cast<std::int64_t>(frame.pixels()), describe(entry, "primary", threads));
    return round.time(options_, [&](std::size_t i, BenchResult& result) {
      if (entries_[i].reference)
        set_errors(result, trace_errors(entries_[i].reference->frame, frame));
      frame.clear();  // so that no contender passes off what another wrote
    });
  }

  [[nodiscard]] std::vector<BenchResult> shadow(int threads) const {
    ShadowFrame frame(TracedFrame(view_.camera.options().size_px).pixels());
    Round round;
    std::vector<const ShadowFrame*> expected;
    for (const Entry& entry : entries_) {
      if (!entry.tracer.shadow || entry.reference->rays.count == 0) continue;
      round.add([&] { return entry.tracer.shadow(entry.reference->rays, threads, frame); },
                entry.reference->rays.count, describe(entry, "shadow", threads));
      expected.push_back(&entry.reference->shadow);
    }
    return round.time(options_, [&](std::size_t i, BenchResult& result) {
      result.hit_flips = shadow_flips(*expected[i], frame);
      constexpr std::uint8_t kNeverWritten = 2;
      std::fill(frame.begin(), frame.end(), kNeverWritten);
    });
  }

 private:
  struct Entry {
    const Contender& contender;
    ViewTracer tracer;
    const Reference* reference;
  };

  [[nodiscard]] BenchResult describe(const Entry& entry, const char* rays, int threads) const {
    BenchResult result;
    result.dem = dem_.name;
    result.view = view_.name;
    result.rays = rays;
    result.contender = entry.contender.name;
    result.threads = threads;
    if (entry.contender.surface) result.surface = name_of(*entry.contender.surface);
    result.build_s = entry.contender.build_s;
    result.memory_mib = entry.contender.memory_mib;
    return result;
  }

  const BenchDem& dem_;
  const BenchView& view_;
  const MeasureOptions& options_;
  std::map<SurfaceModel, Reference> references_;
  std::vector<Entry> entries_;
};

}  // namespace

std::vector<BenchResult> measure(const BenchDem& dem, const BenchView& view,
                                 const std::vector<Contender>& contenders,
                                 const MeasureOptions& options) {
  const Measurement measurement(dem, view, contenders, options);
  std::vector<BenchResult> results;
  const auto append = [&](std::vector<BenchResult> more) {
    results.insert(results.end(), std::make_move_iterator(more.begin()),
                   std::make_move_iterator(more.end()));
  };
  for (const int threads : options.threads) append(measurement.primary(threads));
  for (const int threads : options.threads) append(measurement.shadow(threads));
  return results;
}

}  // namespace terrview

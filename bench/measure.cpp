#include "bench/measure.h"

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <functional>
#include <iterator>
#include <map>
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

  [[nodiscard]] double hit_share() const {
    return static_cast<double>(rays.count) / static_cast<double>(frame.pixels());
  }
  [[nodiscard]] double shadow_share() const {
    return static_cast<double>(std::count(shadow.begin(), shadow.end(), 1)) /
           static_cast<double>(rays.count);
  }
};

Reference make_reference(const Terrain& terrain, const BenchView& view) {
  TracedFrame frame(view.camera.options().size_px);
  trace_rays(terrain, view.camera, 0, frame);
  ShadowRays rays = shadow_rays(terrain, view, frame);
  ShadowFrame shadow(frame.pixels());
  shade_rays(terrain, view, nullptr, rays, 0, shadow);
  return {std::move(frame), std::move(rays), std::move(shadow)};
}

using Ground = std::pair<SurfaceModel, BenchEarth>;

Ground ground_of(const Contender& contender) { return {*contender.surface, contender.earth}; }

std::map<Ground, Reference> make_references(const BenchDem& dem, const BenchView& view,
                                            const std::vector<Contender>& contenders) {
  std::map<Ground, Reference> references;
  for (const Contender& contender : contenders) {
    if (!contender.surface || references.contains(ground_of(contender))) continue;
    const auto terrain = terrain_on(contender.earth, dem, view, *contender.surface, Search::plain);
    references.emplace(ground_of(contender), make_reference(*terrain, view));
  }
  return references;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

// Seconds of a clock. One thread is timed by its own processor time, which other programs on the
// machine do not spend.
double seconds_now(int threads) {
  timespec now{};
  clock_gettime(threads == 1 ? CLOCK_THREAD_CPUTIME_ID : CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void set_speed(BenchResult& result, const FrameWork& work, std::int64_t rays, double seconds) {
  const auto count = static_cast<double>(rays);
  result.ray_count = rays;
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

// One kind of rays with one number of threads: every contender in turns.
class Round {
 public:
  Round(const MeasureOptions& options, int threads) : options_(options), threads_(threads) {}

  // `run` traces one frame of `rays` rays.
  void add(std::function<FrameWork()> run, std::int64_t rays, BenchResult result) {
    turns_.push_back({std::move(run), rays, std::move(result), {}, {}, 0});
  }

  // check(i, result) compares the frame that the i-th has just written for the first time.
  template <class Check>
  std::vector<BenchResult> time(Check check) {
    for (int repetition = 0; repetition < options_.repetitions; ++repetition)
      for (std::size_t i = 0; i < turns_.size(); ++i) {
        if (turns_[i].spent_s > options_.budget_s) continue;
        take(turns_[i]);
        if (repetition == 0) check(i, turns_[i].result);
      }
    std::vector<BenchResult> results;
    for (Turns& turns : turns_) {
      set_speed(turns.result, turns.work, turns.rays, median(turns.seconds));
      results.push_back(std::move(turns.result));
    }
    return results;
  }

 private:
  struct Turns {
    std::function<FrameWork()> run;
    std::int64_t rays;
    BenchResult result;
    FrameWork work;
    std::vector<double> seconds;
    double spent_s;
  };

  void take(Turns& turns) const {
    const double start_s = seconds_now(threads_);
    turns.work = turns.run();
    turns.seconds.push_back(seconds_now(threads_) - start_s);
    turns.spent_s += turns.seconds.back();
  }

  const MeasureOptions& options_;
  int threads_;
  std::vector<Turns> turns_;
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
                          contender.surface ? &references_.at(ground_of(contender)) : nullptr});
  }

  [[nodiscard]] std::vector<BenchResult> primary(int threads) const {
    TracedFrame frame(view_.camera.options().size_px);
    Round round(options_, threads);
    std::vector<const Reference*> expected;
    for (const Entry& entry : entries_) {
      if (!entry.tracer.primary) continue;
      round.add([&] { return entry.tracer.primary(threads, frame); },
                static_cast<std::int64_t>(frame.pixels()), describe(entry, "primary", threads));
      expected.push_back(entry.reference);
    }
    return round.time([&](std::size_t i, BenchResult& result) {
      if (const Reference* reference = expected[i]) {
        set_errors(result, trace_errors(reference->frame, frame));
        result.hit_share = reference->hit_share();
      }
      frame.clear();  // so that no contender passes off what another wrote
    });
  }

  [[nodiscard]] std::vector<BenchResult> shadow(int threads) const {
    ShadowFrame frame(TracedFrame(view_.camera.options().size_px).pixels());
    Round round(options_, threads);
    std::vector<const Reference*> expected;
    for (const Entry& entry : entries_) {
      if (!entry.tracer.shadow || entry.reference->rays.count == 0) continue;
      round.add([&] { return entry.tracer.shadow(entry.reference->rays, threads, frame); },
                entry.reference->rays.count, describe(entry, "shadow", threads));
      expected.push_back(entry.reference);
    }
    return round.time([&](std::size_t i, BenchResult& result) {
      result.hit_flips = shadow_flips(expected[i]->shadow, frame);
      result.hit_share = expected[i]->shadow_share();
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
  std::map<Ground, Reference> references_;
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
  const auto wants = [&](const char* rays) {
    return options.rays.empty() ||
           std::find(options.rays.begin(), options.rays.end(), rays) != options.rays.end();
  };
  for (const int threads : options.threads)
    if (wants("primary")) append(measurement.primary(threads));
  for (const int threads : options.threads)
    if (wants("shadow")) append(measurement.shadow(threads));
  return results;
}

}  // namespace terrview

#include "cli/batch/batch_run.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <new>
#include <thread>

#include "cli/batch/job_plan.h"
#include "cli/camera_json.h"
#include "cli/interrupt.h"
#include "cli/output_file.h"
#include "cli/plan.h"
#include "cli/progress.h"
#include "cli/view_command.h"
#include "cli/view_light.h"
#include "render/parallel.h"
#include "render/stopwatch.h"
#include "terrain/error.h"

namespace terrview {
namespace {

int thread_count(int threads) {
  return threads > 0 ? threads : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

double posts_of(const std::vector<Dem>& dems) {
  double posts = 0;
  for (const Dem& dem : dems) posts += static_cast<double>(dem.grid->columns) * dem.grid->rows;
  return posts;
}

glm::ivec2 picture_size_px(const ViewOptions& options, const Dem& dem) {
  if (options.crop) return options.crop->size_px;
  if (!options.plan) return options.size_px.value_or(ResolvedView{}.size_px);
  try {
    return plan_lattice(options, dem).size_px;
  } catch (const InputError&) {
    return {0, 0};  // it cannot be made
  }
}

double pixel_bytes(const Job& job) {
  constexpr double kPicture_bytes = 100;
  constexpr double kLayers_bytes = 280;
  constexpr double kPlan_bytes = 32;
  if (job.options.plan) return kPlan_bytes;
  return job.outputs.size() > 1 ? kLayers_bytes : kPicture_bytes;
}

class Run {
 public:
  Run(const std::vector<const Job*>& jobs, const BatchGround& ground, InputStamps& stamps,
      ManifestFile& manifest, const BatchRunOptions& options)
      : jobs_(jobs),
        ground_(ground),
        manifest_(manifest),
        bar_("views", options.show_bar),
        threads_(thread_count(options.threads)),
        in_flight_(views_in_flight(jobs, ground.dems, threads_, options.memory_bytes)) {
    for (const Job* job : jobs) job_inputs_.push_back(inputs_now(*job, stamps));
  }

  BatchOutcome work() {
    run_workers(in_flight_, [this] {
      for (std::size_t i = next_++; i < jobs_.size() && !interrupted_; i = next_++) one(i);
    });
    outcome_.interrupted = interrupted_;
    std::sort(outcome_.failed.begin(), outcome_.failed.end(),
              [](const FailedJob& a, const FailedJob& b) { return a.job->index < b.job->index; });
    return std::move(outcome_);
  }

 private:
  void one(std::size_t i) {
    const Job& job = *jobs_[i];
    JobRecord record{job.index, job.name, job.fingerprint, job_inputs_[i], {}, 0, ""};
    Stopwatch stopwatch;
    try {
      check_interrupt();
      make(job, record);
    } catch (const Interrupted&) {
      interrupted_ = true;
      return;
    } catch (const std::bad_alloc&) {
      record.error = "out of memory: use a --window of the DEM or a smaller --size";
    } catch (const std::exception& error) {
      record.error = error.what();
    }
    record.seconds = stopwatch.lap();
    manifest_.append(record.line());
    count(job, record.error);
  }

  void make(const Job& job, JobRecord& record) {
    if (!job.error.empty()) throw InputError(job.error);
    if (!ground_.error.empty()) throw InputError(ground_.error);
    ViewOptions options = job.options;
    options.quiet = true;
    options.threads = std::max(1, threads_ / in_flight_);
    for (const std::string& path : job.outputs) make_folder_of(path);
    ViewFiles files(options);
    make_picture(options, ground_.dems, inputs_, files, {});
    for (const std::string& path : job.outputs) {
      const auto stamp = stamp_file(path);
      if (!stamp) throw std::runtime_error("'" + path + "': is gone");
      record.outputs.push_back(*stamp);
    }
  }

  void count(const Job& job, const std::string& error) {
    const std::lock_guard lock(mutex_);
    if (error.empty())
      ++outcome_.done;
    else
      outcome_.failed.push_back({&job, error});
    const auto finished = static_cast<double>(outcome_.failed.size()) + outcome_.done;
    bar_.report(finished / static_cast<double>(jobs_.size()));
  }

  const std::vector<const Job*>& jobs_;
  const BatchGround& ground_;
  ManifestFile& manifest_;
  std::vector<std::vector<FileStamp>> job_inputs_;
  SharedInputs inputs_;
  ProgressBar bar_;
  int threads_;
  int in_flight_;
  std::atomic<std::size_t> next_ = 0;
  std::atomic<bool> interrupted_ = false;
  std::mutex mutex_;
  BatchOutcome outcome_;
};

}  // namespace

double view_bytes(const Job& job, const std::vector<Dem>& dems) {
  constexpr double kSkyView_bytes = 32;  // a post
  constexpr double kSunMap_bytes = 4;
  constexpr double kView_bytes = 8 << 20;
  const glm::dvec2 size(picture_size_px(job.options, dems.front()));
  const double sky_view = job.options.light.sky_azimuths > 0 ? kSkyView_bytes * posts_of(dems) : 0;
  const bool has_sun_map = casts_shadows(job.options.light) && !job.options.light.soft_shadows;
  const double sun_map = has_sun_map ? kSunMap_bytes * posts_of(dems) : 0;
  return kView_bytes + sky_view + sun_map + pixel_bytes(job) * size.x * size.y;
}

int views_in_flight(const std::vector<const Job*>& jobs, const std::vector<Dem>& dems, int threads,
                    double memory_bytes) {
  constexpr double kProgram_bytes = 160 << 20;
  constexpr double kHeights_bytes = 4 * (1 + 2.0 / 3);  // a post, with ceilings and means
  if (dems.empty()) return 1;
  const double posts = posts_of(dems);
  double largest = 1;
  for (const Job* job : jobs)
    if (job->error.empty()) largest = std::max(largest, view_bytes(*job, dems));
  const bool flooded = std::any_of(jobs.begin(), jobs.end(), [](const Job* job) {
    return !job->options.water.file.empty();  // lakes take a copy
  });
  const double free_bytes =
      memory_bytes - kProgram_bytes - kHeights_bytes * posts * (flooded ? 2 : 1);
  const double fitting = std::clamp(free_bytes / largest, 1.0, static_cast<double>(threads));
  return std::max(1, std::min(static_cast<int>(fitting), static_cast<int>(jobs.size())));
}

BatchOutcome run_jobs(const std::vector<const Job*>& jobs, const BatchGround& ground,
                      InputStamps& stamps, ManifestFile& manifest, const BatchRunOptions& options) {
  return Run(jobs, ground, stamps, manifest, options).work();
}

}  // namespace terrview

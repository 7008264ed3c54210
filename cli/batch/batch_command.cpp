#include "cli/batch/batch_command.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <system_error>

#include "cli/batch/batch_files.h"
#include "cli/batch/batch_options.h"
#include "cli/batch/batch_report.h"
#include "cli/batch/batch_run.h"
#include "cli/batch/job_plan.h"
#include "cli/batch/merge.h"
#include "cli/batch/shared_palette.h"
#include "cli/interrupt.h"
#include "cli/output_file.h"
#include "cli/progress.h"
#include "cli/view_command.h"
#include "cli/view_messages.h"
#include "ingest/memory_limit.h"
#include "ingest/shared_tables.h"
#include "terrain/error.h"

namespace terrview {
namespace {

namespace fs = std::filesystem;

ManifestFile::Existing existing(const BatchOptions& options) {
  if (options.resume) return ManifestFile::Existing::go_on;
  return options.view.overwrite ? ManifestFile::Existing::replace : ManifestFile::Existing::refuse;
}

ManifestFile open_manifest(const BatchOptions& options, const Shard& shard) {
  const std::string path = manifest_path(options, shard);
  make_folder_of(path);
  return {path, existing(options)};
}

ManifestHeader header_of(const std::vector<Job>& jobs, const Shard& shard) {
  std::string all;
  for (const Job& job : jobs) all += job.fingerprint + "\n";
  return {static_cast<int>(jobs.size()), shard, hash_of(all)};
}

std::vector<Job> jobs_of(const BatchOptions& options) {
  const JobTable table = options.path.empty() ? read_job_table(options.table)
                                              : read_camera_path(options.path, options.moving);
  return make_jobs(table, {options.dems, options.values, options.ignore_columns});
}

BatchGround read_ground(const BatchOptions& options, ShowBar show) {
  BatchGround ground;
  DemOptions how = options.view.dem;
  ProgressBar bar("reading", show);
  how.progress = [&](double share) {
    check_interrupt();
    bar.report(share);
  };
  try {
    ground.dems = read_dems(options.dems, how);
    make_shared_tables(ground.dems, options.view.threads);
  } catch (const InputError& error) {
    ground.error = error.what();
  }
  return ground;
}

// Read when it is first needed.
class LazyGround {
 public:
  LazyGround(const BatchOptions& options, ShowBar show) : options_(options), show_(show) {}

  const BatchGround& get() {
    if (!ground_) ground_ = read_ground(options_, show_);
    return *ground_;
  }

 private:
  const BatchOptions& options_;
  ShowBar show_;
  std::optional<BatchGround> ground_;
};

// Makes it unless a batch that goes on has one, and lets every view use it.
void share_palette(BatchOptions& options, const Shard& shard, const std::vector<Job>& jobs,
                   LazyGround& lazy) {
  const std::string path = palette_path(options);
  std::error_code ignored;
  if (!options.resume || !fs::exists(path, ignored)) {
    if (!lazy.get().error.empty()) throw InputError(lazy.get().error);
    const Palette palette =
        make_shared_palette(palette_jobs(jobs), lazy.get().dems, options.view.threads);
    make_folder_of(path);
    save_shared_palette(palette, path, palette_path(options, shard_suffix(shard) + "-own"),
                        options.resume || options.view.overwrite);
  }
  options.values.erase("palette");
  options.values["use-palette"] = {path};
}

// Throws InputError where no view could be made: a batch that has not begun leaves nothing then.
void check_can_begin(const BatchOptions& options, const Shard& shard, const std::vector<Job>& jobs,
                     LazyGround& lazy) {
  const bool hopeless =
      std::none_of(jobs.begin(), jobs.end(), [](const Job& job) { return job.error.empty(); });
  if (hopeless)
    throw InputError("no view can be made: " + jobs.front().label() + ": " + jobs.front().error);
  std::error_code ignored;
  const bool goes_on = options.resume && fs::exists(manifest_path(options, shard), ignored);
  if (!goes_on && !lazy.get().error.empty()) throw InputError(lazy.get().error);
}

int run_table(BatchOptions options) {
  const ShowBar bar = show_bar(options.view);
  const Shard shard = find_shard(options.shard, std::getenv);
  LazyGround lazy(options, bar);
  std::vector<Job> jobs = jobs_of(options);
  check_batch_files(options, shard, jobs);
  check_can_begin(options, shard, jobs, lazy);
  if (options.shared_palette) {
    share_palette(options, shard, jobs, lazy);
    jobs = jobs_of(options);
  }
  for (Job& job : jobs) job.options.overwrite = options.resume || options.view.overwrite;

  ManifestFile manifest = open_manifest(options, shard);
  InputStamps stamps;
  const JobPlan plan = plan_jobs(jobs, shard, manifest.before(), stamps);
  remove_leftovers(outputs_of(plan));
  manifest.reserve(plan.to_do.size() + plan.renumbered.size() + 1);
  manifest.append(header_of(jobs, shard).line());
  if (shard.count > 1 && !options.view.quiet)
    std::fprintf(stderr, "shard %d/%d\n", shard.number, shard.count);
  for (const JobRecord& record : plan.renumbered) manifest.append(record.line());

  BatchOutcome outcome;
  if (!plan.to_do.empty()) {
    const BatchGround& ground = lazy.get();
    if (!options.view.quiet) say_what_was_read(ground.dems);
    outcome =
        run_jobs(plan.to_do, ground, stamps, manifest,
                 {options.view.threads, memory_limit_bytes(options.view.dem.memory_bytes), bar});
  }
  return report_batch(options, plan, outcome, manifest);
}

}  // namespace

int run_batch(const std::vector<std::string>& args) {
  const BatchOptions options = parse_batch(args);
  if (!options.merge.empty()) return merge_manifests(options.merge, options.view);
  return run_table(options);
}

}  // namespace terrview

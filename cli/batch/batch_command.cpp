#include "cli/batch/batch_command.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>

#include "cli/batch/batch_options.h"
#include "cli/batch/batch_report.h"
#include "cli/batch/batch_run.h"
#include "cli/batch/job_plan.h"
#include "cli/batch/merge.h"
#include "cli/batch/output_template.h"
#include "cli/batch/shared_palette.h"
#include "cli/interrupt.h"
#include "cli/output_file.h"
#include "cli/progress.h"
#include "cli/view_messages.h"
#include "ingest/memory_limit.h"
#include "ingest/shared_tables.h"
#include "terrain/error.h"

namespace terrview {
namespace {

namespace fs = std::filesystem;

// A name beside the outputs: in the folder that the template names before its first hole.
std::string name_beside(const BatchOptions& options, const std::string& name) {
  const std::string beginning = OutputTemplate("-o", options.view.output).beginning();
  return beginning.substr(0, beginning.rfind('/') + 1) + name;
}

std::string manifest_path(const BatchOptions& options, const Shard& shard) {
  const fs::path table(options.source());
  if (options.manifest.empty())
    return name_beside(options, table.stem().string() + shard_suffix(shard) + ".jsonl");
  fs::path path(options.manifest);
  path.replace_filename(path.stem().string() + shard_suffix(shard) + path.extension().string());
  return path.string();
}

ManifestFile::Existing existing(const BatchOptions& options) {
  if (options.resume) return ManifestFile::Existing::go_on;
  return options.view.overwrite ? ManifestFile::Existing::replace : ManifestFile::Existing::refuse;
}

ManifestFile open_manifest(const BatchOptions& options, const Shard& shard) {
  const fs::path path = manifest_path(options, shard);
  std::error_code told_when_it_is_opened;
  if (path.has_parent_path()) fs::create_directories(path.parent_path(), told_when_it_is_opened);
  return {path.string(), existing(options)};
}

void check_outputs_are_new(const std::vector<Job>& jobs, const Shard& shard) {
  std::error_code ignored;
  for (const Job& job : jobs) {
    if (!shard.has(job.index)) continue;
    for (const std::string& path : job.outputs)
      if (fs::exists(path, ignored))
        throw InputError("'" + path +
                         "': exists already: give --overwrite to replace it, or --resume to go on");
  }
}

void check_manifest_is_no_output(const std::vector<Job>& jobs, const std::string& manifest) {
  const fs::path place = fs::absolute(manifest).lexically_normal();
  for (const Job& job : jobs)
    for (const std::string& path : job.outputs)
      if (fs::absolute(path).lexically_normal() == place)
        throw InputError("'" + manifest + "': is written by " + job.label() +
                         ": name another --manifest");
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

std::string palette_path(const BatchOptions& options, const std::string& suffix = "") {
  return name_beside(options,
                     fs::path(options.source()).stem().string() + suffix + ".palette.json");
}

BatchGround read_ground(const BatchOptions& options, bool shows_bar) {
  BatchGround ground;
  DemOptions how = options.view.dem;
  ProgressBar bar("reading", shows_bar);
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
  LazyGround(const BatchOptions& options, bool shows_bar)
      : options_(options), shows_bar_(shows_bar) {}

  const BatchGround& get() {
    if (!ground_) ground_ = read_ground(options_, shows_bar_);
    return *ground_;
  }

 private:
  const BatchOptions& options_;
  bool shows_bar_;
  std::optional<BatchGround> ground_;
};

// Makes it unless a batch that goes on has one, and lets every view use it.
void share_palette(BatchOptions& options, const Shard& shard, LazyGround& lazy) {
  const std::string path = palette_path(options);
  if (!options.resume || !fs::exists(path)) {
    const std::vector<Job> jobs = jobs_of(options);
    const BatchGround& ground = lazy.get();
    if (!ground.error.empty()) throw InputError(ground.error);
    const Palette palette =
        make_shared_palette(palette_jobs(jobs), ground.dems, options.view.threads);
    if (const fs::path folder = fs::path(path).parent_path(); !folder.empty())
      fs::create_directories(folder);
    save_shared_palette(palette, path, palette_path(options, shard_suffix(shard) + "-own"),
                        options.resume || options.view.overwrite);
  }
  options.values.erase("palette");
  options.values["use-palette"] = {path};
}

int run_table(BatchOptions options) {
  const bool shows_bar = !options.view.quiet && (options.view.progress || stderr_is_terminal());
  const Shard shard = find_shard(options.shard, std::getenv);
  LazyGround lazy(options, shows_bar);
  if (options.shared_palette) share_palette(options, shard, lazy);
  std::vector<Job> jobs = jobs_of(options);
  check_manifest_is_no_output(jobs, manifest_path(options, shard));
  const bool replaces = options.resume || options.view.overwrite;
  if (!replaces) check_outputs_are_new(jobs, shard);
  for (Job& job : jobs) job.options.overwrite = replaces;

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
    outcome = run_jobs(
        plan.to_do, ground, stamps, manifest,
        {options.view.threads, memory_limit_bytes(options.view.dem.memory_bytes), shows_bar});
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

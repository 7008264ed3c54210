#include "cli/batch/batch_files.h"

#include <filesystem>
#include <set>
#include <system_error>

#include "cli/batch/manifest.h"
#include "cli/batch/output_template.h"
#include "cli/input_files.h"
#include "terrain/error.h"

namespace terrview {
namespace {

namespace fs = std::filesystem;

std::string name_beside(const BatchOptions& options, const std::string& name) {
  const std::string beginning = OutputTemplate("-o", options.view.output).beginning();
  return beginning.substr(0, beginning.rfind('/') + 1) + name;
}

InputFiles files_read(const BatchOptions& options, const std::vector<Job>& jobs) {
  std::set<std::string> paths(options.dems.begin(), options.dems.end());
  paths.insert(options.source());
  for (const Job& job : jobs) paths.insert(job.inputs.begin(), job.inputs.end());
  return {{paths.begin(), paths.end()}, "this batch"};
}

void check_is_no_output(const std::string& file, const std::vector<Job>& jobs,
                        const std::string& instead) {
  const fs::path place = fs::absolute(file).lexically_normal();
  for (const Job& job : jobs)
    for (const std::string& path : job.outputs)
      if (fs::absolute(path).lexically_normal() == place)
        throw InputError("'" + file + "': is written by " + job.label() + ": " + instead);
}

}  // namespace

std::string manifest_path(const BatchOptions& options, const Shard& shard) {
  const fs::path table(options.source());
  if (options.manifest.empty())
    return name_beside(options, table.stem().string() + shard_suffix(shard) + ".jsonl");
  fs::path path(options.manifest);
  path.replace_filename(path.stem().string() + shard_suffix(shard) + path.extension().string());
  return path.string();
}

std::string palette_path(const BatchOptions& options, const std::string& suffix) {
  return name_beside(options,
                     fs::path(options.source()).stem().string() + suffix + ".palette.json");
}

void check_batch_files(const BatchOptions& options, const Shard& shard,
                       const std::vector<Job>& jobs) {
  const InputFiles inputs = files_read(options, jobs);
  const auto check = [&](const std::string& file, const std::string& instead) {
    inputs.refuse(file, instead);
    check_is_no_output(file, jobs, instead);
  };
  check(manifest_path(options, shard), "name another --manifest");
  if (options.shared_palette) check(palette_path(options), "rename the table");
  const bool replaces = options.resume || options.view.overwrite;
  std::error_code ignored;
  for (const Job& job : jobs) {
    for (const std::string& path : job.outputs) {
      inputs.refuse(path);
      if (!replaces && shard.has(job.index) && fs::exists(path, ignored))
        throw InputError("'" + path +
                         "': exists already: give --overwrite to replace it, or --resume to go on");
    }
  }
  if (!replaces) check_is_new(manifest_path(options, shard));
}

}  // namespace terrview
